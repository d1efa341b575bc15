#pragma once

#include <map>
#include <string>

#include <QMainWindow>

#include "app/services/layouts/layout_book.h"
#include "app/services/pad/pad_memory.h"
#include "app/window/panes/pane_table.h"
#include "app/window/shell/asks_before_closing.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

class ClosingQuestion;
class CommandTable;
class LayoutFeature;
class LiveBridge;
class MapView;
class MissionFeature;
class PadFeature;
class PaneDocks;
class MeasuresFeature;
class PreflightFeature;
class RobotsFeature;
class Selection;
class WindowFrame;

/// The window with live robots (docs/design.md, "The window"): a bar with all robots and STOP, and below it
/// the panes of its features, placed by the present layout. It only combines features.
class LiveWindow final : public QMainWindow, public AsksBeforeClosing {
    Q_OBJECT
public:
    LiveWindow(LiveBridge& bridge, const MapViewSettings& view, LayoutBook layouts = {},
               PadMemory pads = PadMemory({}), QWidget* parent = nullptr);
    ~LiveWindow() override;

    [[nodiscard]] MapView& mapView() const;
    /// Returns the present view of the map, to be stored. Its look is the operator's own, not that of the
    /// layout.
    [[nodiscard]] MapViewSettings view() const;
    void setLook(MapLook look);  ///< look of the map, in the present layout
    void closeUnasked() override;
    [[nodiscard]] Selection& selection() const { return *m_selection; }
    [[nodiscard]] CommandTable& commands() const { return *m_commands; }
    [[nodiscard]] PaneDocks& panes() const { return *m_panes; }
    [[nodiscard]] MissionFeature& mission() const { return *m_mission; }
    [[nodiscard]] PreflightFeature& preflight() const { return *m_preflight; }
    [[nodiscard]] MeasuresFeature& measures() const { return *m_measures; }
    [[nodiscard]] LayoutFeature& layouts() const { return *m_layouts; }
    [[nodiscard]] const QString& selected() const;
    [[nodiscard]] bool driving() const;
    [[nodiscard]] QString newest() const;      ///< newest message
    [[nodiscard]] QStringList recent() const;  ///< messages, newest first
    /// Returns texts about what is not visible yet. Empty when each robot is connected, a scan is registered
    /// and drawn, and each camera pane shows a picture.
    [[nodiscard]] QString missing() const;

signals:
    void closing();
    void languageWanted(const QString& code);  ///< requests a new window in this language

public slots:
    void setDriving(bool on);
    void showMessage(const QString& text);  ///< as the newest message; also adds it to the list of messages

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void build();
    void connectFeatures();

    LiveBridge& m_bridge;
    Selection* m_selection;
    CommandTable* m_commands;
    PaneDocks* m_panes;
    LayoutFeature* m_layouts = nullptr;
    RobotsFeature* m_robots = nullptr;
    MissionFeature* m_mission = nullptr;
    PadFeature* m_pads = nullptr;
    PreflightFeature* m_preflight = nullptr;
    MeasuresFeature* m_measures = nullptr;
    ClosingQuestion* m_closing = nullptr;
    PaneFeatures m_features;
    WindowFrame* m_frame = nullptr;
};

}  // namespace leitstand
