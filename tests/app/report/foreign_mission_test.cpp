#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/session/report/report_source.h"
#include "core/io/bag/bag_writer.h"
#include "tests/support/rooms.h"
#include "tests/support/temporary_folder.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

constexpr double Ahead = 0.4, Up = 0.5;  ///< of the base: where the scanner sits [m]
constexpr int Steps = 12;                ///< of a drive: 1.2 m ahead, then a right angle on the spot

/// Where the robot is after @p step of Steps.
Pose baseInRoom(int step) {
    const double way = std::min(step, 6) * 0.2, turn = std::max(0, step - 6) * degrees(15);
    return poseFrom({-1.5 + way, 0.5, 0.0}, 0, 0, turn);
}

/// Odometry counts from afar.
Pose roomInOdom() {
    return poseFrom({400.0, -70.0, 0.0}, 0, 0, degrees(30));
}

/// A bag of somebody else's robot, whose scanner sits before its base as tf_static tells.
class ForeignBag {
public:
    explicit ForeignBag(const fs::path& folder) : m_writer(std::move(BagWriter::open(folder)).value()) {}

    void write(double seconds, const std::string& topic, const Sample& sample) {
        const std::string type(typeOf(sample));
        auto payload = encode(sample, type);
        ASSERT_TRUE(payload.ok()) << payload.error().text;
        m_writer->addTopic({topic, type, qosProfilesOf({}), "", "", false, false, "cdr"});
        m_writer->write({++m_sequence, at(seconds), topic, type, std::move(payload).value()});
    }
    void drive() {
        const Pose sensorInBase = poseFrom({Ahead, 0.0, Up}, 0, 0, 0);
        TransformsSample tree;
        tree.transforms.push_back({{at(0), "base_link"}, "lidar", sensorInBase});
        write(0.0, "/rover/tf_static", tree);
        for (int step = 0; step <= Steps; ++step) {
            for (const double part : {0.0, 0.3, 0.6}) {
                OdometrySample odometry;
                odometry.header = {at(step + part), "odom"};
                odometry.childFrame = "base_link";
                odometry.baseInOdom = roomInOdom() * baseInRoom(step);
                write(step + part, "/rover/odom", odometry);
                if (part != 0.3 || step % 2 != 0) continue;
                RoomSettings room;
                room.sensorInRoom = baseInRoom(step) * sensorInBase;
                room.rows = 80;
                room.columns = 140;
                room.seed = static_cast<unsigned>(step + 1);
                CloudSample cloud;
                cloud.header = {at(step + part), "lidar"};
                for (const Eigen::Vector3f& point : scanRoom(room).scan.points) {
                    if (point.allFinite()) cloud.points.push_back(point);
                }
                write(step + part + 0.01, "/rover/points", cloud);
            }
        }
        EXPECT_TRUE(m_writer->close().ok());
    }
    [[nodiscard]] static Time at(double seconds) {
        return Time(std::chrono::seconds(1'700'000'000)) +
               std::chrono::nanoseconds(std::llround(seconds * 1e9));
    }

private:
    std::unique_ptr<BagWriter> m_writer;
    std::uint64_t m_sequence = 0;
};

TEST(ForeignReport, TrailAndStartAreTheBasesAndNotTheScanners) {
    const TemporaryFolder folder;
    ForeignBag(folder / "rover").drive();
    const auto source = ReportSource::open(folder / "rover");
    ASSERT_TRUE(source) << source.error().text;
    ASSERT_GE(source->input().scans.size(), 5u);
    for (const ReportScan& scan : source->input().scans) {
        const Eigen::Vector3d sits = scan.sensorInBase.translation();
        EXPECT_LT((sits - Eigen::Vector3d(Ahead, 0.0, Up)).norm(), 1e-6) << sits.transpose();
    }
    const ReportModel model = reportOf(source->input());
    ASSERT_EQ(model.robots.size(), 1u);
    const auto& path = model.robots.front().path.poses;
    ASSERT_GT(path.size(), 6u);
    EXPECT_LT(path.front().baseInMap.translation().norm(), 0.02) << "it starts at the map's origin";
    // The turn on the spot: the scanner goes along an arc of 0.63 m, the base stays.
    const Pose startInRoom = baseInRoom(0);
    for (const PathPose& pose : path) {
        const double seconds = std::chrono::duration<double>(pose.time - ForeignBag::at(0)).count();
        const Pose truth = startInRoom.inverse() * baseInRoom(static_cast<int>(std::floor(seconds)));
        // Odometry's heading is the map's.
        const Pose turned = poseFrom(Eigen::Vector3d::Zero(), 0, 0, degrees(30));
        EXPECT_LT((pose.baseInMap.translation() - turned * truth.translation()).norm(), 0.06) << seconds;
    }
    EXPECT_NEAR(model.robots.front().length, 1.2, 0.1);
}

}  // namespace
}  // namespace leitstand::test
