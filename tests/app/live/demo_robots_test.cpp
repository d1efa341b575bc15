#include "app/window/live/demo_robots.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/source/live_bridge.h"
#include "core/io/robot/robot_file.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

TEST(DemoRobots, AreThereAsLongAsTheyAreWanted) {
    const TestDomain domain;
    const QTemporaryDir folder;
    StationSettings settings;
    settings.domain.domain = domain.number();
    settings.mission.folder = std::filesystem::path(folder.path().toStdString()) / "mission";
    settings.memory = std::filesystem::path(folder.path().toStdString()) / "station.yaml";
    for (const char* name : {"kurt3d", "crawler"}) {
        settings.mission.robots.push_back(
            readRobot(sourceFolder() + "/resources/robots/" + name + ".yaml").value());
    }
    auto opened = LiveBridge::open(settings);
    ASSERT_TRUE(opened.ok()) << opened.error().text;
    const auto bridge = std::move(opened).value();
    DemoSettings demo;
    demo.program = QString::fromStdString(program("leitstand-robot"));
    demo.domain = domain.number();
    auto robots = std::make_unique<DemoRobots>(demo);
    QSignalSpy failed(robots.get(), &DemoRobots::failed);
    QSignalSpy pictures(bridge.get(), &LiveBridge::pictured);
    robots->start();
    const auto state = [&](const char* robot) { return bridge->station().robot(robot).link.state; };
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return state("kurt3d") == LinkState::Connected && state("crawler") == LinkState::Connected; },
        60'000))
        << (failed.isEmpty() ? std::string() : failed[0][0].toString().toStdString());
    EXPECT_TRUE(QTest::qWaitFor([&] { return pictures.count() > 10; }, 30'000));
    robots.reset();
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return state("kurt3d") == LinkState::Lost && state("crawler") == LinkState::Lost; }, 30'000))
        << "they end with the object";
}

TEST(DemoRobots, AProgramThatIsNotThereIsTold) {
    DemoSettings demo;
    demo.program = QStringLiteral("/no/such/program");
    DemoRobots robots(demo);
    QSignalSpy failed(&robots, &DemoRobots::failed);
    robots.start();
    ASSERT_TRUE(!failed.isEmpty() || failed.wait(5'000));
    EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("/no/such/program"));
}

TEST(DemoRobots, ARobotThatEndsByItselfSaysWhy) {
    DemoSettings demo;
    demo.program = QString::fromStdString(program("leitstand-robot"));
    demo.arena = QStringLiteral("/no/such/arena.yaml");
    DemoRobots robots(demo);
    QSignalSpy failed(&robots, &DemoRobots::failed);
    robots.start();
    ASSERT_TRUE(failed.wait(30'000));
    EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("/no/such/arena.yaml"));
}

}  // namespace
}  // namespace leitstand::test
