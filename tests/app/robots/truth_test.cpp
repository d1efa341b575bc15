#include <chrono>
#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/cloud/scan.h"
#include "core/event/cloud_sample.h"
#include "core/event/picture_samples.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/link/control_station.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// How many of @p points, in the arena's frame, are on a robot there (in a box as big as Kurt3D).
int on(const Pose& robotInArena, const std::vector<Eigen::Vector3d>& points) {
    int count = 0;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d at = robotInArena.inverse() * point;
        count += std::abs(at.x()) < 0.28 && std::abs(at.y()) < 0.23 && at.z() > 0.06 && at.z() < 0.7 ? 1 : 0;
    }
    return count;
}

std::vector<Eigen::Vector3d> pointsOf(const CloudSample& cloud, const Pose& laserInArena) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3f& point : cloud.points) {
        if (point.allFinite()) points.emplace_back(laserInArena * point.cast<double>());
    }
    return points;
}

std::vector<Eigen::Vector3d> pointsOf(const RangesSample& scan, const Pose& laserInArena) {
    std::vector<Eigen::Vector3d> points;
    double angle = scan.angleMin;
    for (const float range : scan.ranges) {
        if (std::isfinite(range) && range <= scan.rangeMax)
            points.emplace_back(laserInArena *
                                (range * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)));
        angle += scan.angleStep;
    }
    return points;
}

/// Kurt3D and the Crawler face to face, each in the arena that its file tells.
class RobotsFaceToFace : public testing::Test {
protected:
    /// @p names: of the arenas that they are in.
    void start(const std::string& ofKurt3d, const std::string& ofCrawler) {
        writeText(m_folder / "a.yaml", hallFile(ofKurt3d));
        writeText(m_folder / "b.yaml", hallFile(ofCrawler));
        m_kurt3d = std::make_unique<RobotProcess>(m_domain, "kurt3d", arena("a.yaml"));
        m_crawler = std::make_unique<RobotProcess>(m_domain, "crawler", arena("b.yaml"));
        ASSERT_TRUE(m_kurt3dSaid.receives("/kurt3d/points") && m_crawlerSaid.receives("/crawler/scan"));
    }
    std::vector<std::string> arena(const std::string& file) const {
        return {"--arena", (m_folder / file).string(), "--seed", "7"};
    }
    Pose laser(const std::string& robot, const std::string& sensor, const Truth& truth) const {
        return truth.newest(robot, robot)->baseInOdom * shippedRobot(robot).sensors.at(sensor).sensorInBase;
    }
    /// Points of slices from the one numbered @p from on that are on the Crawler.
    int onCrawler(std::size_t from, const Pose& laserInArena, const Pose& crawler) const {
        const auto slices = m_kurt3dSaid.all<CloudSample>("/kurt3d/points");
        int count = 0;
        for (std::size_t i = from; i < slices.size(); ++i)
            count += on(crawler, pointsOf(slices[i], laserInArena));
        return count;
    }
    int onKurt3d(const Pose& laserInArena, const Pose& kurt3d) const {
        return on(kurt3d, pointsOf(m_crawlerSaid.all<RangesSample>("/crawler/scan").back(), laserInArena));
    }
    const TemporaryFolder m_folder;
    const TestDomain m_domain;
    std::unique_ptr<Node> m_node = nodeIn(m_domain);
    RobotListener m_kurt3dSaid{*m_node, shippedRobot("kurt3d")},
        m_crawlerSaid{*m_node, shippedRobot("crawler")};
    std::unique_ptr<RobotProcess> m_kurt3d, m_crawler;
};

TEST_F(RobotsFaceToFace, TheyShareTheirPosesAndMeasureEachOther) {
    Truth truth(m_domain, "hall", "");
    start("hall", "hall");
    ASSERT_TRUE(truth.listener().receives(truth.topic("kurt3d")) &&
                truth.listener().receives(truth.topic("crawler")));
    const Pose kurt3d = truth.newest("kurt3d", "kurt3d")->baseInOdom,
               crawler = truth.newest("crawler", "crawler")->baseInOdom;
    EXPECT_LT((kurt3d.translation() - Eigen::Vector3d(-0.8, 0, 0)).norm(), 0.05);
    EXPECT_LT((crawler.translation() - Eigen::Vector3d(0.8, 0, 0)).norm(), 0.05);
    EXPECT_EQ(truth.newest("kurt3d", "kurt3d")->header.frame, "arena");
    const Pose scanner = laser("kurt3d", "scanner", truth), urg = laser("crawler", "laser", truth);
    EXPECT_TRUE(waitUntil([&] { return onCrawler(0, scanner, crawler) > 30; }, 60s));
    EXPECT_TRUE(waitUntil([&] { return onKurt3d(urg, kurt3d) > 10; }, 60s));

    // Killed, it is out of the other's way when nothing was heard of it for 5 s.
    m_kurt3d->end(SIGKILL);
    EXPECT_TRUE(waitUntil([&] { return onKurt3d(urg, kurt3d) == 0; }, 60s));
    const auto scans = m_crawlerSaid.count("/crawler/scan");
    EXPECT_TRUE(m_crawlerSaid.receives("/crawler/scan", scans + 5));
    // Back again, it is seen again.
    m_kurt3d = std::make_unique<RobotProcess>(m_domain, "kurt3d", arena("a.yaml"));
    EXPECT_TRUE(waitUntil([&] { return onKurt3d(urg, kurt3d) > 10; }, 60s));
}

TEST_F(RobotsFaceToFace, InArenasOfOtherNamesTheyAreAlone) {
    Truth one(m_domain, "hall_7", ""), other(m_domain, "hall_8", "");
    start("hall 7", "hall 8");
    ASSERT_TRUE(one.listener().receives(one.topic("kurt3d"), 20) &&
                other.listener().receives(other.topic("crawler"), 20));
    const Pose kurt3d = one.newest("kurt3d", "kurt3d")->baseInOdom,
               crawler = other.newest("crawler", "crawler")->baseInOdom;
    const Pose scanner = laser("kurt3d", "scanner", one), urg = laser("crawler", "laser", other);
    ASSERT_TRUE(m_kurt3dSaid.receives("/kurt3d/points", 25)) << "a whole turn";
    EXPECT_EQ(onCrawler(0, scanner, crawler), 0);
    EXPECT_EQ(onKurt3d(urg, kurt3d), 0);
    EXPECT_EQ(one.listener().count(one.topic("crawler")), 0u);
    EXPECT_EQ(other.listener().count(other.topic("kurt3d")), 0u);
}

TEST(RobotTruth, VictimsAndContactsAreTold) {
    const TemporaryFolder folder;
    std::string arena = hallFile("hall");
    const std::string start = "crawler: {position: [0.8, 0, 0]";
    arena.replace(arena.find(start), start.size(), "crawler: {position: [-2.0, 0, 0]");
    writeText(folder / "hall.yaml", arena);
    const TestDomain domain;
    const auto node = nodeIn(domain);
    RobotListener reported(*node, shippedRobot("crawler"));
    RobotProcess robot(domain, "crawler", {"--arena", (folder / "hall.yaml").string()});
    Truth truth(domain, "hall", "");  // afterwards: victims stay
    ASSERT_TRUE(truth.listener().receives(truth.topic("victims")));
    const auto victims = truth.listener().all<SightingSample>(truth.topic("victims")).front();
    EXPECT_EQ(victims.header.frame, "arena");
    ASSERT_EQ(victims.sightings.size(), 1u);
    EXPECT_EQ(victims.sightings[0].text, "V-01");
    EXPECT_EQ(victims.sightings[0].kind, "victim");
    EXPECT_DOUBLE_EQ(victims.sightings[0].value, 35.0);
    EXPECT_LT((victims.sightings[0].position - Eigen::Vector3d(1.2, 1.6, 0)).norm(), 1e-9);
    EXPECT_EQ(truth.listener().count(truth.topic("contacts")), 0u);

    ASSERT_TRUE(reported.receives("/crawler/stop_state"));
    ControlStation station(*node, shippedRobot("crawler"));
    station.ask();
    ASSERT_TRUE(waitUntil([&] { return station.mayDrive(); }));
    ASSERT_TRUE(station.driveUntil(0.3, [&] { return truth.listener().count(truth.topic("contacts")) > 0; }))
        << robot.out();
    station.push(0.0);
    const auto contacts = truth.listener().all<BumpSample>(truth.topic("contacts")).back();
    EXPECT_EQ(contacts.header.frame, "crawler/base_link");
    ASSERT_EQ(contacts.bumpers.size(), 1u);
    EXPECT_EQ(contacts.bumpers[0].name, "area west");
    EXPECT_GE(contacts.bumpers[0].hits, 1u);
    EXPECT_TRUE(waitUntil([&] {
        for (const Bumper& bumper : reported.all<BumpSample>("/crawler/bumps").back().bumpers) {
            if (bumper.hits > 0) return true;
        }
        return false;
    })) << "the robot itself";
}

TEST(RobotTruth, LabelsOfPointsAreToldWhileSomebodyListens) {
    const TemporaryFolder folder;
    writeText(folder / "hall.yaml", hallFile("hall"));
    const TestDomain domain;
    const auto node = nodeIn(domain);
    RobotListener reported(*node, shippedRobot("kurt3d"));
    RobotProcess robot(domain, "kurt3d", {"--arena", (folder / "hall.yaml").string()});
    ASSERT_TRUE(reported.receives("/kurt3d/points", 20));
    Truth truth(domain, "hall", "kurt3d");
    const std::string labels = truth.topic("kurt3d/labels");
    ASSERT_TRUE(truth.listener().receives(labels, 15));
    EXPECT_EQ(truth.listener().on(labels).front().writerSequence, 1u) << "nothing before that";
    int compared = 0;
    std::vector<int> points(LabelCount);
    for (const PictureSample& picture : truth.listener().all<PictureSample>(labels)) {
        for (const CloudSample& cloud : reported.all<CloudSample>("/kurt3d/points")) {
            if (cloud.header.stamp != picture.header.stamp) continue;
            ++compared;
            ASSERT_EQ(picture.height, cloud.rows);
            ASSERT_EQ(picture.width, cloud.columns);
            for (std::size_t i = 0; i < cloud.points.size(); ++i) {
                const auto label = std::to_integer<std::size_t>(picture.content.bytes[i]);
                ASSERT_LT(label, points.size());
                if (cloud.points[i].allFinite()) ++points[label];
            }
        }
    }
    EXPECT_GE(compared, 10);
    EXPECT_GT(points[std::size_t(Label::Floor)], 1'000);
    EXPECT_GT(points[std::size_t(Label::Wall)], 1'000);
    EXPECT_THAT(truth.listener().errors(), testing::IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
