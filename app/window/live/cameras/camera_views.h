#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <QObject>
#include <QStringList>

#include "app/session/station/picture_feed.h"
#include "app/window/live/live_context.h"
#include "core/robot/robot_description.h"
#include "widgets/models/live/picture_age.h"

namespace leitstand {

class CameraPane;
struct CameraOverlay;
struct LiveMoment;

/// The selected robot's cameras: its first one large ("camera"), with what the driver has to know in it, and
/// another or the infrared one beside it ("right").
class CameraViews final : public QObject {
    Q_OBJECT
public:
    explicit CameraViews(const LiveContext& context);

    /// Cameras that are in a pane and have sent no picture yet.
    [[nodiscard]] QStringList missing() const;

signals:
    void driveWanted();  ///< the large picture was clicked

private:
    /// What came of one camera.
    struct Camera {
        PictureAge age;
        ShownPicturePtr newest;
    };
    void choose();  ///< cameras for the panes of a robot newly selected
    void next();    ///< in the small pane
    void showPicture(const ShownPicturePtr& picture);
    void showNewest(const std::string& sensor);
    static void showIn(CameraPane& pane, const ShownPicture& picture);
    void show(const LiveMoment& moment);
    void showAge(CameraPane& pane, const std::string& sensor, const LiveMoment& moment);
    [[nodiscard]] CameraOverlay overlay(const RobotDescription& robot, const LiveMoment& moment) const;

    LiveContext m_context;
    CameraPane *m_large, *m_small;
    std::string m_largeSensor, m_smallSensor;
    std::map<std::pair<std::string, std::string>, Camera> m_cameras;  ///< by robot and sensor
};

}  // namespace leitstand
