#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QMainWindow>

#include "app/window/live/drive_input.h"
#include "app/window/live/live_bridge.h"
#include "app/window/view_state.h"
#include "widgets/models/live/gas_trend.h"
#include "widgets/models/live/picture_age.h"

class QLabel;
class QSplitter;

namespace leitstand {

class CameraPane;
class DriveStrip;
class MapPane;
class MapView;
class RobotBar;
class StopButton;
class VirtualScanPane;

/// The window on live robots (design, section 7): the selected robot's camera large, beside it the map, its
/// virtual scan and its infrared or right camera; below what it does; above all robots and STOP.
class LiveWindow final : public QMainWindow {
    Q_OBJECT
public:
    LiveWindow(LiveBridge& bridge, const MapViewSettings& view, QWidget* parent = nullptr);
    ~LiveWindow() override;

    [[nodiscard]] MapView& mapView() const;
    [[nodiscard]] const QString& selected() const { return m_selected; }
    [[nodiscard]] bool driving() const { return m_input.hasFocus(); }
    /// What is not to be seen yet; empty: each robot is connected, a turn is registered, and each camera pane
    /// shows a picture.
    [[nodiscard]] QString missing() const;

public slots:
    void select(const QString& robot);
    void setDriving(bool on);
    void tell(const QString& text);  ///< shows it as the newest message

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    /// What came of one camera.
    struct Camera {
        PictureAge age;
        ShownPicturePtr newest;
    };
    void build();
    void addCommands();
    void connectBridge();
    void connectPanes();
    void refresh();
    void refreshPanes(const RobotDescription& robot, const RobotView& view, const RobotState& said);
    void showPicture(const ShownPicturePtr& picture);
    void showIn(CameraPane& pane, const ShownPicture& picture);
    void swapViews();
    void toggleRight();
    [[nodiscard]] static QString cameraTitle(const std::string& sensor);
    [[nodiscard]] const RobotDescription* description(const QString& robot) const;
    [[nodiscard]] int placeOf(const QString& robot) const;
    /// Cameras of a robot in its file's order, the thermal ones last.
    [[nodiscard]] std::vector<const StreamDescription*> camerasOf(const RobotDescription& robot) const;

    LiveBridge& m_bridge;
    ViewState m_view;
    DriveInput m_input{*this};
    QString m_selected;
    std::string m_large, m_small;                                     ///< sensors in the panes
    std::map<std::pair<std::string, std::string>, Camera> m_cameras;  ///< by robot and sensor
    std::map<std::string, GasTrend> m_gas;                            ///< by robot
    MapPane* m_map = nullptr;
    CameraPane *m_camera = nullptr, *m_right = nullptr;
    VirtualScanPane* m_scan = nullptr;
    DriveStrip* m_strip = nullptr;
    RobotBar* m_bar = nullptr;
    StopButton* m_stop = nullptr;
    QLabel* m_word = nullptr;  ///< newest message
    QSplitter *m_big = nullptr, *m_side = nullptr;
    bool m_mapSeen = false;
};

}  // namespace leitstand
