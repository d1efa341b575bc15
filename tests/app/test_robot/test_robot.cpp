#include "tests/app/test_robot/test_robot.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "core/event/cloud_sample.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/io/clouds/scan_source.h"
#include "tests/support/rooms.h"
#include "transport/convert/encode.h"
#include "transport/dds/node.h"
#include "transport/security/enclave.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

Time now() {
    return std::chrono::time_point_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now());
}

/// Where the laser sits on the robot.
Pose laserInBase() {
    return poseFrom({0.1, 0.0, 0.4}, 0.0, degrees(3), 0.0);
}

std::vector<Scan> generatedRooms() {
    std::vector<Scan> scans;
    for (int i = 0; i < 3; ++i) {
        RoomSettings settings;
        settings.sweep = Sweep::Yawing;
        settings.rows = 181;
        settings.columns = 161;
        settings.seed = static_cast<unsigned>(i + 1);
        settings.sensorInRoom = poseFrom({0.4 * i - 0.4, 0.1 * i, 0.8}, 0.0, 0.0, degrees(6 * i));
        scans.push_back(scanRoom(settings).scan);
    }
    return scans;
}

Result<std::vector<Scan>> scansOf(const std::string& folder) {
    if (folder.empty()) return generatedRooms();
    const auto files = listScans({folder});
    if (!files) return files.error();
    std::vector<Scan> scans;
    for (const auto& file : *files) {
        auto scan = readScan(file);
        if (!scan) return scan.error();
        scans.push_back(std::move(scan).value().scan);
    }
    return scans;
}

/// Rows @p first to @p last of a scan as a message.
CloudSample cloudOf(const Scan& scan, int first, int last, const std::string& frame, Time stamp) {
    CloudSample cloud;
    cloud.header = {stamp, frame};
    cloud.rows = last - first;
    cloud.columns = scan.columns;
    const auto at = [&](int row) {
        return scan.points.begin() +
               static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(scan.columns);
    };
    cloud.points.assign(at(first), at(last));
    return cloud;
}

class TestRobot {
public:
    TestRobot(const TestRobotSettings& settings, std::unique_ptr<Node> node)
        : m_settings(settings), m_node(std::move(node)) {}
    Result<void> run(const std::vector<Scan>& scans, const std::atomic<bool>& stopped);

private:
    Result<void> publish(const std::string& leaf, const Sample& sample, const Qos& qos,
                         Flow flow = Flow::Telemetry);
    Result<void> sayOdometry();
    Result<void> saySweep(const Scan& scan, const std::atomic<bool>& stopped);
    Result<void> sayWhereTheLaserSits();
    Result<void> keepGoing(double seconds, const std::atomic<bool>& stopped);

    TestRobotSettings m_settings;
    std::unique_ptr<Node> m_node;
    std::map<std::string, std::unique_ptr<Publisher>> m_publishers;
    Pose m_baseInOdom = Pose::Identity();
    int m_said = 0;
};

Result<void> TestRobot::publish(const std::string& leaf, const Sample& sample, const Qos& qos, Flow flow) {
    const std::string type(typeOf(sample));
    auto& publisher = m_publishers[leaf];
    if (!publisher) {
        auto made = m_node->publisher(
            {.topic = "/" + m_settings.name + "/" + leaf, .type = type, .qos = qos, .flow = flow});
        if (!made) return made.error();
        publisher = std::move(made).value();
    }
    const auto payload = encode(sample, type);
    return payload ? publisher->write(*payload) : Result<void>(payload.error());
}

Result<void> TestRobot::sayOdometry() {
    OdometrySample odometry;
    odometry.header = {now(), m_settings.name + "/odom"};
    odometry.childFrame = m_settings.name + "/base_link";
    odometry.baseInOdom = m_baseInOdom;
    return publish("odom", odometry, {.reliability = Qos::Reliability::BestEffort, .depth = 10});
}

Result<void> TestRobot::sayWhereTheLaserSits() {
    FrameTransform transform;
    transform.header = {now(), m_settings.name + "/base_link"};
    transform.childFrame = m_settings.name + "/laser";
    transform.childInParent = laserInBase();
    return publish("tf_static", TransformsSample{{transform}},
                   {.durability = Qos::Durability::TransientLocal, .depth = 100});
}

Result<void> TestRobot::keepGoing(double seconds, const std::atomic<bool>& stopped) {
    const auto until = Clock::now() + std::chrono::duration<double>(seconds);
    do {
        if (const auto reported = sayOdometry(); !reported) return reported;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    } while (Clock::now() < until && !stopped);
    return {};
}

Result<void> TestRobot::saySweep(const Scan& scan, const std::atomic<bool>& stopped) {
    m_baseInOdom = scan.sensorInOdom * laserInBase().inverse();
    if (const auto reported = keepGoing(m_settings.pauseSeconds, stopped); !reported) return reported;
    for (int slice = 0; slice < m_settings.slices && !stopped; ++slice) {
        const int first = scan.rows * slice / m_settings.slices,
                  last = scan.rows * (slice + 1) / m_settings.slices;
        const CloudSample cloud = cloudOf(scan, first, last, m_settings.name + "/laser", now());
        if (const auto reported = publish("points", cloud, {.depth = 600}, Flow::Scans); !reported)
            return reported;
        ++m_said;
        if (const auto reported = keepGoing(0.05, stopped); !reported) return reported;
    }
    return keepGoing(m_settings.pauseSeconds, stopped);
}

Result<void> TestRobot::run(const std::vector<Scan>& scans, const std::atomic<bool>& stopped) {
    auto points = m_node->publisher({.topic = "/" + m_settings.name + "/points",
                                     .type = "sensor_msgs/msg/PointCloud2",
                                     .qos = {.depth = 600},
                                     .flow = Flow::Scans});
    if (!points) return points.error();
    m_publishers.emplace("points", std::move(points).value());
    if (const auto reported = sayWhereTheLaserSits(); !reported) return reported;
    const Publisher& clouds = *m_publishers.at("points");
    while (clouds.matched() < m_settings.waitForReaders && !stopped) {
        if (const auto reported = keepGoing(0.02, stopped); !reported) return reported;
    }
    for (const Scan& scan : scans) {
        if (const auto reported = saySweep(scan, stopped); !reported) return reported;
    }
    const auto until = Clock::now() + std::chrono::seconds(30);
    while (!clouds.waitForAcknowledgments(std::chrono::milliseconds(1))) {
        if (Clock::now() > until) return Error{"clouds were not acknowledged"};
        if (const auto reported = keepGoing(0.0, stopped); !reported) return reported;
    }
    std::printf("said %d\n", m_said);
    std::fflush(stdout);
    while (!stopped) {
        if (const auto reported = keepGoing(0.5, stopped); !reported) return reported;
    }
    return {};
}

}  // namespace

Result<void> runTestRobot(const TestRobotSettings& settings, const std::atomic<bool>& stopped) {
    const auto scans = scansOf(settings.scans);
    if (!scans) return scans.error();
    NodeSettings network;
    network.domain = settings.domain;
    network.name = settings.name;
    if (!settings.keys.empty()) {
        auto files = securityFiles(settings.keys);
        if (!files) return files.error();
        network.security = std::move(files).value();
    }
    auto node = Node::create(network);
    if (!node) return node.error();
    return TestRobot(settings, std::move(node).value()).run(*scans, stopped);
}

}  // namespace leitstand::test
