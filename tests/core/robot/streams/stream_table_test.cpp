#include "core/robot/streams/stream_table.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/event/stream_role.h"

namespace leitstand {
namespace {

TEST(StreamTable, HasARowForEveryRoleThatHasAName) {
    for (int role = 0; role < 256; ++role) {
        const bool named = !toString(static_cast<StreamRole>(role)).empty();
        const bool row = static_cast<std::size_t>(role) < streamTable().size();
        EXPECT_EQ(named, row) << "role " << role << " " << toString(static_cast<StreamRole>(role));
    }
}

TEST(StreamTable, NoTwoRolesAreTakenForEachOther) {
    std::set<std::string> topics, words;
    for (const StreamFacts& row : streamTable()) {
        const std::string word(row.inLog.empty() ? toString(row.role) : std::string(row.inLog));
        EXPECT_TRUE(words.insert(word).second) << word << " in the log is two roles";
        if (row.ofCamera) continue;  // told apart by their cameras' names
        EXPECT_TRUE(topics.insert(std::string(row.topic)).second) << row.topic << " is of two roles";
    }
}

TEST(StreamTable, QuickStreamsAreSteadyAndCommandsAreNot) {
    for (const StreamFacts& row : streamTable()) {
        EXPECT_TRUE(row.steady || !(row.quick || row.alwaysOn)) << toString(row.role);
        EXPECT_FALSE(row.steady && isCommand(row.role)) << toString(row.role);
        // Commands to joints differ by their groups.
        EXPECT_TRUE(row.single || !isCommand(row.role) || row.role == StreamRole::JointCommand)
            << "which command would be obeyed?";
    }
}

}  // namespace
}  // namespace leitstand
