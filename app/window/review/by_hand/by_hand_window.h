#pragma once

#include <QMainWindow>
#include <QString>
#include <QStringList>

#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

class ByHandBridge;
class CommandTable;
class MapFeature;
class MapView;
class PaneDocks;
class Selection;
class WindowFrame;

/// The window for decisions about the map of a mission that has ended: the map and its scans, and the live
/// window's commands for them. It only combines features.
class ByHandWindow final : public QMainWindow {
    Q_OBJECT
public:
    ByHandWindow(ByHandBridge& bridge, const MapViewSettings& view, QWidget* parent = nullptr);
    ~ByHandWindow() override;

    [[nodiscard]] MapView& mapView() const;
    [[nodiscard]] const MapViewSettings& view() const;
    [[nodiscard]] CommandTable& commands() const { return *m_commands; }
    [[nodiscard]] PaneDocks& panes() const { return *m_panes; }
    [[nodiscard]] QString newest() const;  ///< newest message
    /// Returns texts about what of the map is not visible yet. Empty when a scan is drawn.
    [[nodiscard]] QStringList missing() const;

signals:
    void closing();

public slots:
    void showMessage(const QString& text);  ///< as the newest message; also adds it to the list of messages

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void build();

    ByHandBridge& m_bridge;
    Selection* m_selection;
    CommandTable* m_commands;
    PaneDocks* m_panes;
    MapFeature* m_map = nullptr;
    WindowFrame* m_frame = nullptr;
};

}  // namespace leitstand
