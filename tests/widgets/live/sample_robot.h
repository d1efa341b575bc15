#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/event/motion_samples.h"
#include "core/mission/state/robot_state.h"
#include "core/robot/robot_description.h"
#include "core/station/robot_view.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/live/robots/value_trend.h"

namespace leitstand::test {

/// The station's clock in these tests.
[[nodiscard]] inline Time at(double seconds) {
    return Time(std::chrono::seconds(1'700'000'000)) +
           std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * seconds));
}

/// A robot as it stands in a corridor, well connected, driven, all of its streams of now (at(0)).
struct SampleRobot {
    RobotDescription description;
    RobotFace face;
    RobotView view;
    RobotState reported;
    ValueTrend gas;
};
[[nodiscard]] SampleRobot sampleRobot(const std::string& letter = "K", const std::string& title = "Kurt3D",
                                      int place = 0);

/// A corridor 1.6 m wide, closed 1.2 m behind and 5 m ahead, a niche to the left; a box at the front right
/// whose nearest corner is @p gap from the body's right front edge, ahead [m].
[[nodiscard]] VirtualScanView corridor(double gap = 0.9);
/// The odometry of a robot that rolls and pitches [rad].
[[nodiscard]] OdometrySample odometryOf(double speed, double turn, double roll, double pitch);
/// What its chains do, left and right [m/s]; empty: they do not tell.
[[nodiscard]] std::shared_ptr<const JointSample> trackSpeeds(std::vector<double> speeds);
/// Its mode as it says it.
void setMode(SampleRobot& robot, const std::string& mode, bool autonomous = false,
             const std::string& reason = {});
/// A stop of this station, so far as told.
void setStop(SampleRobot& robot, bool acknowledged, bool standing);

}  // namespace leitstand::test
