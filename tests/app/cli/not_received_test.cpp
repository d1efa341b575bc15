// What is announced and does not come is told by the recorder, which joins the network again.
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/robot/robot_file.h"
#include "tests/app/recording.h"
#include "tests/support/dds/quiet_robot.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// The JSON in @p out, among lines of errors.
json jsonIn(const std::string& out) {
    const auto begin = out.find("{\n"), end = out.rfind("\n}\n");
    if (begin == std::string::npos || end == std::string::npos) return {};
    return json::parse(out.substr(begin, end + 2 - begin));
}

class NotReceived : public testing::Test {
protected:
    /// Waits until the recorder has joined the domain, and then again.
    [[nodiscard]] bool joinedAgain() {
        return waitUntil([&] { return m_robot.seen() >= 2; }, std::chrono::seconds(60));
    }
    const TestDomain m_domain;
    const TemporaryFolder m_folder;
    QuietRobot m_robot{m_domain, must(readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml"))};
};

TEST_F(NotReceived, WhatIsAnnouncedAndDoesNotComeIsToldAndTheRecorderJoinsAgain) {
    Recording recording(m_domain, m_folder / "mission", {"--robot", "kurt3d", "--json"});
    ASSERT_TRUE(joinedAgain()) << recording.out();
    EXPECT_THAT(recording.out(),
                HasSubstr("Kurt3D: announced, but nothing comes: /kurt3d/odom; joining the network again"));
    // It joined again a moment ago, and all is announced anew: what did not come before is told all the same.
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    EXPECT_EQ(jsonIn(recording.out())["unheard"], json({"/kurt3d/odom"})) << recording.out();
    EXPECT_THAT(recording.out(), HasSubstr("announced, but nothing came of it: /kurt3d/odom\n"));
}

TEST_F(NotReceived, WhatComesAfterJoiningAgainIsRecordedAndNoMoreTold) {
    Recording recording(m_domain, m_folder / "mission", {"--robot", "kurt3d", "--json"});
    ASSERT_TRUE(joinedAgain()) << recording.out();
    ASSERT_TRUE(waitUntil(
        [&] {
            m_robot.speak();
            return !recordedOn(m_folder / "mission", "/kurt3d/odom").empty();
        },
        std::chrono::seconds(60)))
        << recording.out();
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    EXPECT_EQ(jsonIn(recording.out())["unheard"], json::array()) << recording.out();
    EXPECT_THAT(recording.out(), Not(HasSubstr("nothing came of it")));
}

TEST_F(NotReceived, WithoutRobotFilesItIsToldAtTheEndAsText) {
    Recording recording(m_domain, m_folder / "mission");
    ASSERT_TRUE(waitUntil([&] { return m_robot.seen() >= 1; }, std::chrono::seconds(60)));
    std::this_thread::sleep_for(std::chrono::seconds(4));  // longer than it takes to hear it
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    EXPECT_THAT(recording.out(), HasSubstr("announced, but nothing came of it: /kurt3d/odom\n"));
}

}  // namespace
}  // namespace leitstand::test
