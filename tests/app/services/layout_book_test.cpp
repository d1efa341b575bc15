#include "app/services/layouts/layout_book.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

class LayoutBookTest : public testing::Test {
protected:
    LayoutBookTest() {
        std::filesystem::create_directories(m_folder.path() / "shipped");
        for (const char* name : {"drive", "explore", "map", "review", "link", "report", "compare"}) {
            std::ofstream(m_folder.path() / "shipped" / (std::string(name) + ".yaml"))
                << "title: " << name << "\npanes: {pane: camera}\n";
        }
    }
    [[nodiscard]] std::vector<std::string> titles() {
        std::vector<std::string> found;
        m_errors.clear();
        for (const WindowLayout& layout : m_book.all(m_errors)) found.push_back(layout.title);
        return found;
    }

    const TemporaryFolder m_folder;
    const LayoutBook m_book{m_folder.path() / "own", m_folder.path() / "shipped"};
    std::vector<std::string> m_errors;
};

TEST_F(LayoutBookTest, OwnLayoutsComeAfterTheShippedOnesAndStay) {
    EXPECT_THAT(titles(),
                testing::ElementsAre("drive", "explore", "map", "review", "link", "report", "compare"));
    WindowLayout mine = m_book.find("map").value();
    mine.name = "mine";
    mine.title = "Mine";
    ASSERT_TRUE(m_book.save(mine).ok());
    EXPECT_THAT(titles(), testing::ElementsAre("drive", "explore", "map", "review", "link", "report",
                                               "compare", "Mine"));
    EXPECT_TRUE(m_book.isOwn("mine"));
    ASSERT_TRUE(m_book.remove("mine").ok());
    EXPECT_THAT(titles(), SizeIs(7));
    EXPECT_THAT(m_book.remove("mine").error().text, HasSubstr("mine"));
}

TEST_F(LayoutBookTest, AnOwnLayoutGoesBeforeTheShippedOneUntilItIsDeleted) {
    WindowLayout drive = m_book.find("drive").value();
    drive.title = "My way";
    ASSERT_TRUE(m_book.save(drive).ok());
    EXPECT_EQ(m_book.find("drive")->title, "My way");
    EXPECT_THAT(titles(), SizeIs(7));
    ASSERT_TRUE(m_book.remove("drive").ok());
    EXPECT_EQ(m_book.find("drive")->title, "drive");
}

TEST_F(LayoutBookTest, ADamagedFileIsToldAndTheShippedOneUsed) {
    std::filesystem::create_directories(m_folder.path() / "own");
    std::ofstream(m_folder.path() / "own" / "drive.yaml") << "panes: {vertical: 3}\n";
    EXPECT_THAT(titles(),
                testing::ElementsAre("drive", "explore", "map", "review", "link", "report", "compare"));
    ASSERT_THAT(m_errors, SizeIs(1));
    EXPECT_THAT(m_errors.front(), HasSubstr("drive.yaml:1"));
}

TEST_F(LayoutBookTest, NamesThatLeaveTheFolderAreNone) {
    WindowLayout bad = m_book.find("drive").value();
    bad.name = "../drive";
    EXPECT_FALSE(m_book.save(bad).ok());
    EXPECT_FALSE(m_book.find("../shipped/drive").ok());
    EXPECT_THAT(m_book.find("drove").error().text, HasSubstr("drive, explore, link, map"));
}

}  // namespace
}  // namespace leitstand::test
