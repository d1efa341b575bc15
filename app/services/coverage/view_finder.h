#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/places/sensor_places.h"
#include "core/mission/coverage/search_view.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct Event;

/// A place from which a robot's camera looked.
struct FoundView {
    SearchSensor sensor = SearchSensor::Camera;
    Pose opticalInMap = Pose::Identity();
    SearchField field;
};

/// Finds from where the cameras of one robot looked, picture by picture. The caller reports where the robot
/// is. It has no thread; one call at a time.
class ViewFinder {
public:
    /// One picture per camera in this time is used; more add nothing.
    static constexpr std::chrono::milliseconds Every{200};
    static constexpr double Fastest =
        0.9;  ///< pictures of a camera that turns faster than this are blurred [rad/s]

    explicit ViewFinder(const RobotDescription& robot);
    ViewFinder(const ViewFinder&) = delete;
    ViewFinder& operator=(const ViewFinder&) = delete;

    /// Takes odometry, inertial unit, transforms, camera infos and pictures of this robot; ignores other
    /// events.
    void onEvent(const Event& event);
    /// Sets where the robot was. Before the first call, nothing can be placed.
    void correct(const MapFix& fix) { m_places.correct(fix); }
    void lose() { m_places.lose(); }  ///< call when the robot's place is unknown
    /// Views found since the last call.
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
        Time taken{};                ///< time of the newest picture, robot's clock
        std::optional<Pose> before;  ///< pose of the optical frame in the odometry frame at the last picture
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
