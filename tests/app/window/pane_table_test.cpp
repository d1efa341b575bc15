#include "app/window/panes/pane_table.h"

#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/layouts/layout_book.h"

namespace leitstand::test {
namespace {

TEST(PaneTable, EveryPaneHasAnIdAndATitleOfItsOwnInEachWindow) {
    std::set<std::string> ids, former;
    for (const PaneRow& row : paneTable()) {
        EXPECT_TRUE(ids.insert(row.id).second) << row.id << " stands twice";
        EXPECT_STRNE(row.title, "") << row.id;
        EXPECT_TRUE(row.live != nullptr || row.review != nullptr || row.byHand != nullptr)
            << row.id << ": no window has it";
        if (*row.formerId != '\0') former.insert(row.formerId);
    }
    for (const std::string& id : former) EXPECT_FALSE(ids.contains(id)) << id << " means two panes";
}

TEST(PaneTable, LayoutsThatAreShippedNamePanesOfTheTable) {
    std::set<std::string> ids;
    for (const PaneRow& row : paneTable()) ids.insert(row.id);
    std::vector<std::string> errors;
    for (const WindowLayout& layout : LayoutBook().all(errors)) {
        for (const std::string& id : panesIn(layout.panes))
            EXPECT_TRUE(ids.contains(id)) << "layout " << layout.name << ": no pane " << id;
    }
    EXPECT_THAT(errors, testing::IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
