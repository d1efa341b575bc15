#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/robot_keys.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"
#include "tests/io/robot/robot_texts.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

/// The pages about robots' files.
std::string page() {
    const std::filesystem::path docs = std::filesystem::path(sourceFolder()) / "docs";
    return readText(docs / "robots.md") + readText(docs / "robot-joints.md") +
           readText(docs / "robot-readings.md") + readText(docs / "robot-drawings.md");
}

/// Rows of the tables in the chapter @p title whose first cell is code: their cells.
std::vector<std::vector<std::string>> rowsOf(const std::string& title) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream in(page());
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("## ")) inside = line == "## " + title;
        if (!inside || !line.starts_with("| `")) continue;
        std::vector<std::string> cells;
        for (std::size_t at = 2, end = 0; (end = line.find(" |", at)) != std::string::npos; at = end + 3) {
            cells.push_back(line.substr(at, end - at));
        }
        rows.push_back(std::move(cells));
    }
    return rows;
}

TEST(RobotDocs, TellEveryKeyAndNoOther) {
    std::vector<std::string> reported;
    for (const auto& cells : rowsOf("Keys")) reported.push_back(cells[0].substr(1, cells[0].size() - 2));
    EXPECT_THAT(reported, testing::UnorderedElementsAreArray(detail::allRobotKeys()));
}

std::string qosWords(const Qos& qos) {
    return fmt::format("{}{}, {}{}",
                       qos.reliability == Qos::Reliability::Reliable ? "reliable" : "best effort",
                       qos.durability == Qos::Durability::TransientLocal ? ", transient local" : "",
                       qos.depth, qos.lifespan > 0.0 ? fmt::format(", lifespan {} s", qos.lifespan) : "");
}

TEST(RobotDocs, TellEveryRoleWithTopicTypesAndQos) {
    const auto rows = rowsOf("Roles");
    ASSERT_EQ(rows.size(), allStreamRoles().size());
    for (const StreamRole role : allStreamRoles()) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& cells) {
            return cells[0] == fmt::format("`{}`", toString(role));
        });
        ASSERT_NE(row, rows.end()) << toString(role);
        const StreamDescription usual = defaultStream(role, "NAME", "SENSOR");
        const std::string topic = usual.topic.starts_with("/NAME/") ? usual.topic.substr(6) : usual.topic;
        EXPECT_EQ((*row)[1], fmt::format("`{}`", topic));
        EXPECT_EQ((*row)[2], fmt::format("{}", fmt::join(typesOf(role), ", "))) << toString(role);
        EXPECT_EQ((*row)[3], qosWords(usual.qos)) << toString(role);
    }
}

TEST(RobotDocs, ShowFilesThatAreRead) {
    const std::string text = page(), fence = "```yaml\n";
    int files = 0;
    for (std::size_t at = 0; (at = text.find(fence, at)) != std::string::npos; ++files) {
        at += fence.size();
        const auto robot = parseRobot(text.substr(at, text.find("```", at) - at), "docs/robots.md");
        EXPECT_TRUE(robot.ok()) << robot.error().text;
    }
    EXPECT_GE(files, 1);
}

}  // namespace
}  // namespace leitstand::test
