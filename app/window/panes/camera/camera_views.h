#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/services/station/cameras/picture_feed.h"
#include "core/robot/robot_description.h"
#include "widgets/models/live/texts/picture_age.h"

namespace leitstand {

/// The panes that show cameras of the selected robot.
enum class CameraPlace { Large, Small };

/// Holds which camera of the selected robot is in which pane, the newest picture of each camera, and the
/// picture's age.
class CameraViews {
public:
    /// Shows the cameras of @p robot as they were when it was last selected. The first time, its first camera
    /// is large and its last one small (an infrared camera, if it has one). Null: no robot.
    void select(const RobotDescription* robot);
    void took(const ShownPicturePtr& picture, SteadyTime now);
    void forget(const std::string& robot, const std::string& sensor);  ///< discards the camera's picture
    /// Puts the next camera into the small pane, in a cycle that leaves out the camera in the large pane.
    void next();
    /// Swaps the cameras of the two panes.
    void swap();
    [[nodiscard]] bool hasNext() const { return m_streams.size() > 2; }  ///< whether a camera is in no pane

    [[nodiscard]] const RobotDescription* robot() const { return m_robot; }
    /// Returns the stream of the camera in the pane; null: the pane is empty.
    [[nodiscard]] const StreamDescription* stream(CameraPlace place) const;
    [[nodiscard]] std::string sensor(CameraPlace place) const;
    [[nodiscard]] ShownPicturePtr newest(CameraPlace place) const;  ///< null: none was received
    [[nodiscard]] DataAge age(CameraPlace place, SteadyTime now) const;
    /// Returns the age of the newest picture from the camera @p sensor of @p robot.
    [[nodiscard]] DataAge age(const std::string& robot, const std::string& sensor, SteadyTime now) const;

private:
    struct Camera {
        PictureAge age;
        ShownPicturePtr newest;
    };
    struct Choice {
        std::string large, small;
    };
    [[nodiscard]] const Camera* camera(CameraPlace place) const;
    [[nodiscard]] const Choice* choice() const;

    const RobotDescription* m_robot = nullptr;
    std::vector<const StreamDescription*> m_streams;  ///< streams of the robot's cameras, thermal ones last
    std::map<std::string, Choice> m_choices;          ///< by robot
    std::map<std::pair<std::string, std::string>, Camera> m_cameras;  ///< by robot and sensor
};

}  // namespace leitstand
