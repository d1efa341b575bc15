#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/places/sensor_places.h"
#include "core/event/event.h"
#include "core/mission/coverage/search_view.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Somewhere that a robot's camera looked from.
struct FoundView {
    SearchSensor sensor = SearchSensor::Camera;
    Pose opticalInMap = Pose::Identity();
    SearchField field;
};

/// Tells where the cameras of one robot looked from, picture by picture. The caller tells where the robot is.
/// Without thread; one at a time.
class ViewFinder {
public:
    static constexpr std::chrono::milliseconds Every{200};  ///< of a camera; what comes between tells no more
    static constexpr double Fastest = 0.9;  ///< a camera that turns faster shows nothing [rad/s]

    explicit ViewFinder(const RobotDescription& robot);
    ViewFinder(const ViewFinder&) = delete;
    ViewFinder& operator=(const ViewFinder&) = delete;

    /// Odometry, inertial unit, transforms, camera infos and pictures of this robot; others are passed by.
    void onEvent(const Event& event);
    /// Where the robot was; until the first nothing can be placed.
    void correct(const MapFix& fix) { m_places.correct(fix); }
    void lose() { m_places.lose(); }  ///< nobody knows where the robot is
    /// What was seen since the last call.
    [[nodiscard]] std::vector<FoundView> found();

private:
    /// A picture that waits for odometry.
    struct Waiting {
        std::string sensor, frame;
        SearchSensor kind;
        Time stamp, received;
    };
    struct Camera {
        std::optional<SearchField> field;
        Time taken{};                ///< newest picture, robot's clock
        std::optional<Pose> before;  ///< optical frame in the odometry's
        Time beforeAt{};
    };
    void look(Time now);
    void look(const Waiting& picture);

    const RobotDescription m_robot;
    SensorPlaces m_places;
    std::map<std::string, Camera> m_cameras;  ///< by sensor
    std::deque<Waiting> m_waiting;
    std::vector<FoundView> m_found;
};

}  // namespace leitstand
