#include <mutex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "core/io/robot/robot_file.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

RobotDescription shipped(const std::string& name) {
    return must(readRobot(sourceFolder() + "/resources/robots/" + name + ".yaml"));
}

// Both robots as processes in one arena: the Crawler stands 0.8 m to the right of Kurt3D.
TEST(RobotsInMap, TheCrawlerIsPlacedBesideKurt3DAndAgainAfterARestart) {
    const TestDomain domain;
    const TemporaryFolder folder;
    std::mutex mutex;
    std::string words;
    const auto robot = [&](const std::string& kind) {
        return ChildProcess(program("leitstand-robot"), {kind, "--arena", "yellow", "--seed", "7", "--domain",
                                                         std::to_string(domain.number())});
    };
    const ChildProcess kurt = robot("kurt3d"), crawler = robot("crawler");
    StationSettings settings;
    settings.domain.domain = domain.number();
    settings.mission.folder = folder / "mission";
    settings.mission.robots = {shipped("kurt3d"), shipped("crawler")};
    settings.memory = folder / "station.yaml";
    StationListener listener;
    listener.onMessage = [&](const std::string& text) {
        const std::scoped_lock lock(mutex);
        words += text + "\n";
    };
    const auto reported = [&] {
        const std::scoped_lock lock(mutex);
        return words;
    };
    auto station = must(Station::open(settings, listener));
    const auto of = [&](const std::string& name) {
        const RobotsInMapPtr robots = station->mapping().robots();
        for (const RobotInMap& one : *robots) {
            if (one.robot == name) return one;
        }
        return RobotInMap{};
    };
    ASSERT_TRUE(waitUntil([&] { return of("crawler").certain && of("kurt3d").certain; }, 90s)) << reported();
    const auto between = [&] { return Pose(of("kurt3d").baseInMap.inverse() * of("crawler").baseInMap); };
    EXPECT_LT((between().translation() - Eigen::Vector3d(0, -0.8, 0)).norm(), 0.1) << reported();
    EXPECT_LT(inDegrees(angleBetween(between(), Pose::Identity())), 4.0);
    EXPECT_TRUE(waitUntil([&] { return station->mission()->robots.at("crawler")->place != nullptr; }));
    EXPECT_TRUE(waitUntil([&] { return reported().find("Crawler: found in the map") != std::string::npos; }))
        << "by its title: " << reported();

    EXPECT_FALSE(station->mapping().place("nobody", Pose::Identity()).ok());
    const Pose dragged = of("crawler").baseInMap * poseFrom({0.3, 0.2, 0}, 0, 0, degrees(10));
    ASSERT_TRUE(station->mapping().place("crawler", dragged).ok());
    ASSERT_TRUE(waitUntil([&] {
        return station->mission()->robots.at("crawler")->place->sample.cause ==
               RobotPlaceSample::Cause::Operator;
    })) << reported();
    ASSERT_TRUE(
        waitUntil([&] { return of("crawler").certain && between().translation().head<2>().norm() < 0.9; }));
    EXPECT_LT((between().translation() - Eigen::Vector3d(0, -0.8, 0)).norm(), 0.1) << reported();

    station.reset();
    station = must(Station::open(settings, listener));
    EXPECT_TRUE(of("crawler").placed) << "at once, where it was";
    EXPECT_TRUE(waitUntil([&] { return of("crawler").certain; }, 60s)) << reported();
    EXPECT_LT((of("crawler").baseInMap.translation() - dragged.translation()).head<2>().norm(), 0.5);
}

}  // namespace
}  // namespace leitstand::test
