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

/// The window for decisions on the map of a mission that has ended: the map and its scans, and the live
/// window's commands on them. It only puts features together.
class ByHandWindow final : public QMainWindow {
    Q_OBJECT
public:
    ByHandWindow(ByHandBridge& bridge, const MapViewSettings& view, QWidget* parent = nullptr);
    ~ByHandWindow() override;

    [[nodiscard]] MapView& mapView() const;
    [[nodiscard]] const MapViewSettings& view() const;
    [[nodiscard]] CommandTable& commands() const { return *m_commands; }
    [[nodiscard]] PaneDocks& panes() const { return *m_panes; }
    [[nodiscard]] QString newest() const;  ///< message
    /// Returns, in words, what of the map is not visible yet. Empty once a scan is drawn.
    [[nodiscard]] QStringList missing() const;

signals:
    void closing();

public slots:
    void showMessage(const QString& text);  ///< as the newest; keeps it in the list of messages

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
