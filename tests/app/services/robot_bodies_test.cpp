// What robots look like, from models that may be damaged or change all the time.
#include "app/services/models/robot_bodies.h"

#include <mutex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/status_samples.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

LatestPtr<RobotModelSample> model(std::uint64_t sequence, const std::string& body) {
    return latestPtr(Latest<RobotModelSample>{
        sequence, Time{},
        RobotModelSample{"<robot name=\"r\"><link name=\"base_link\">" + body + "</link></robot>"}});
}

std::string box(const std::string& size) {
    return "<visual><geometry><box size=\"" + size + "\"/></geometry></visual>";
}

class Bodies : public testing::Test {
protected:
    Bodies() {
        m_robot.name = "rover";
        m_robot.title = "Rover";
        m_robot.baseFrame = "base_link";
    }
    [[nodiscard]] std::vector<std::string> said() {
        const std::lock_guard lock(m_mutex);
        return m_said;
    }
    RobotDescription m_robot;
    std::mutex m_mutex;
    std::vector<std::string> m_said;
    RobotBodies m_bodies{[this](const std::string& text) {
        const std::lock_guard lock(m_mutex);
        m_said.push_back(text);
    }};
};

TEST_F(Bodies, AreThereSoonAfterTheModel) {
    EXPECT_EQ(m_bodies.body(m_robot, nullptr), nullptr);
    const auto first = model(1, box("1 1 1"));
    EXPECT_TRUE(waitUntil([&] { return m_bodies.body(m_robot, first) != nullptr; }));
    const ModelBodyPtr made = m_bodies.body(m_robot, first);
    EXPECT_EQ(m_bodies.body(m_robot, model(7, box("1 1 1"))), made) << "the same model at another moment";
    EXPECT_THAT(said(), SizeIs(0));
}

TEST_F(Bodies, DamagedModelsAreToldOnceAndDrawnAsSymbols) {
    for (int i = 1; i <= 5; ++i) (void)m_bodies.body(m_robot, model(1, "<visual/>"));
    EXPECT_TRUE(waitUntil([&] { return !said().empty(); }));
    EXPECT_EQ(m_bodies.body(m_robot, model(2, "<visual/>")), nullptr);
    EXPECT_THAT(said(), SizeIs(1));
    EXPECT_THAT(said()[0],
                HasSubstr("Rover: its model is not drawn: rover/robot_description:1: expected <geometry>"));
}

TEST_F(Bodies, AModelLargerThanAnyRobotIsNotDrawn) {
    const auto large = model(1, box("100 1 1"));
    EXPECT_TRUE(waitUntil([&] {
        (void)m_bodies.body(m_robot, large);
        return !said().empty();
    }));
    EXPECT_THAT(said()[0], HasSubstr("farther than 10 m"));
    EXPECT_EQ(m_bodies.body(m_robot, large), nullptr);
}

TEST_F(Bodies, AModelThatKeepsChangingIsDrawnAllTheSame) {
    std::uint64_t number = 0;
    EXPECT_TRUE(waitUntil([&] {
        ++number;
        return m_bodies.body(m_robot, model(number, box("1 1 1") + "<!-- " + std::to_string(number) +
                                                        " -->")) != nullptr;
    }));
}

TEST_F(Bodies, MeshesThatAreNotHereAreTold) {
    const auto mesh = model(1,
                            "<visual><geometry><mesh filename=\"package://rover/a.stl\"/></geometry></visual>"
                            "<collision><geometry><sphere radius=\"0.3\"/></geometry></collision>");
    EXPECT_TRUE(waitUntil([&] { return m_bodies.body(m_robot, mesh) != nullptr && !said().empty(); }));
    EXPECT_THAT(said()[0], HasSubstr("1 meshes of its model are not on this computer"));
    EXPECT_THAT(said()[0], HasSubstr("package rover"));
}

}  // namespace
}  // namespace leitstand::test
