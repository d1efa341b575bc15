#include "tests/widgets/live/sample_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::test {

VirtualScanView corridor(double gap) {
    VirtualScanView view;
    view.at = at(0);
    view.sectors.resize(180);
    const auto through = [](double direction, double x0, double x1, double y0, double y1) {
        const double c = std::cos(direction), s = std::sin(direction);
        return std::min(c > 0 ? x1 / c : c < 0 ? x0 / c : 1e9, s > 0 ? y1 / s : s < 0 ? y0 / s : 1e9);
    };
    const Eigen::Vector2d box(0.225 + gap, -0.30);  // its near corner
    for (int i = 0; i < 180; ++i) {
        VirtualSector& sector = view.sectors[static_cast<std::size_t>(i)];
        const double direction = view.directionOf(i);
        const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
        double length = through(direction, -1.2, 5.0, -0.8, 0.8);
        const bool niche = direction > 0.5 && direction < 1.2;
        if (niche) length = std::min(1.7 / std::sin(direction), 2.6);
        sector.outer = length * along;
        // a turn of the scanner takes 2.3 s; what is behind was seen longer ago
        sector.age = std::abs(direction) > 2.4 ? 8.0 : 0.013 * i;
        const double reach = box.x() / std::max(1e-6, along.x());
        const Eigen::Vector2d hit = reach * along;
        if (along.x() > 0 && hit.y() <= box.y() && hit.y() >= box.y() - 0.3) {
            sector.inner = hit;
            view.obstacles.push_back({hit, sector.age});
        }
    }
    view.obstacles.push_back({box, 0.5});
    return view;
}

OdometrySample odometryOf(double speed, double turn, double roll, double pitch) {
    OdometrySample odometry;
    odometry.baseInOdom = poseFrom({1, 2, 0}, roll, pitch, 0.7);
    odometry.linear.x() = speed;
    odometry.angular.z() = turn;
    return odometry;
}

std::shared_ptr<const JointSample> trackSpeeds(std::vector<double> speeds) {
    return std::make_shared<const JointSample>(
        JointSample{{}, {"left_track", "right_track"}, {}, std::move(speeds), {}});
}

void setMode(SampleRobot& robot, const std::string& mode, bool autonomous, const std::string& reason) {
    ModeSample sample;
    sample.mode = mode;
    sample.autonomous = autonomous;
    sample.reason = reason;
    robot.reported.mode = latestPtr(Latest<ModeSample>{3, at(-5), sample});
}

void setStop(SampleRobot& robot, bool acknowledged, bool standing) {
    robot.view.stop.sent = true;
    robot.view.stop.acknowledged = robot.view.stop.stopped = acknowledged;
    robot.view.stop.standing = standing;
    robot.view.stop.standingKnown = true;
    robot.view.drive.driving = false;
}

SampleRobot sampleRobot(const std::string& letter, const std::string& title, int place) {
    SampleRobot robot;
    RobotDescription& description = robot.description;
    description.letter = letter;
    description.title = title;
    description.name = title;
    std::ranges::transform(title, description.name.begin(),
                           [](char c) { return static_cast<char>(std::tolower(c)); });
    description.footprint = {{0.225, 0.165}, {-0.225, 0.165}, {-0.225, -0.165}, {0.225, -0.165}};
    description.maxRoll = description.maxPitch = degrees(25);
    StreamDescription gasStream;
    gasStream.role = StreamRole::Gas;
    description.streams.push_back(gasStream);
    robot.face = faceOf(description, place);

    LinkStatus& link = robot.view.link;
    link.robot = description.name;
    link.state = LinkState::Connected;
    link.silence = 0.02;
    link.roundTrip = RoundTripStatus{.last = 0.021, .median = 0.022};
    link.streams.resize(2);
    robot.view.grant.mine = true;
    robot.view.grant.holder = "me";
    robot.view.drive = {true, {0.42, 0.0, degrees(-8)}, true, true, false, true};
    robot.view.around = corridor();

    setMode(robot, "teleoperation");
    robot.reported.odometry = latestPtr(
        Latest<OdometrySample>{1, at(-0.03), odometryOf(0.42, degrees(-8), degrees(6), degrees(-3))});
    BatterySample battery;
    battery.fraction = 0.71;
    battery.capacity = 10.0;
    battery.current = -11.2;
    robot.reported.battery = latestPtr(Latest<BatterySample>{4, at(-0.4), battery});
    GasSample gas;
    for (int i = 0; i < 110; ++i) {
        gas.ppm = 640.0 + 12.0 * std::sin(0.9 * i) + (i > 70 ? 13.2 * (i - 70) : 0.0);
        robot.gas.add(at(i - 109.5), gas.ppm);
    }
    gas.ppm = 1180;
    robot.reported.gas = latestPtr(Latest<GasSample>{5, at(-0.5), gas});
    return robot;
}

}  // namespace leitstand::test
