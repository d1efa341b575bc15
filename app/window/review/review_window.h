#pragma once

#include <QMainWindow>

#include "app/services/layouts/layout_book.h"
#include "app/window/panes/pane_table.h"
#include "app/window/review/tidy_progress.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

class CommandTable;
class LayoutFeature;
class MapView;
class PaneDocks;
class ReviewBridge;
class ReviewClock;
class RobotsFeature;
class Selection;
class TimelineFeature;
class WindowFrame;

/// The window on a recorded mission (design, section 7): the live window's panes, and below them the
/// timeline, which they follow. Puts features together; what they do is theirs.
class ReviewWindow final : public QMainWindow {
    Q_OBJECT
public:
    ReviewWindow(ReviewBridge& bridge, const MapViewSettings& view, LayoutBook layouts = {},
                 QWidget* parent = nullptr);
    ~ReviewWindow() override;

    [[nodiscard]] MapView& mapView() const;
    /// How the map is looked at now, but the look is the operator's own, not a layout's: to be remembered.
    [[nodiscard]] MapViewSettings view() const;
    void setLook(MapLook look);  ///< in the layout in use
    [[nodiscard]] Selection& selection() const { return *m_selection; }
    [[nodiscard]] CommandTable& commands() const { return *m_commands; }
    [[nodiscard]] PaneDocks& panes() const { return *m_panes; }
    [[nodiscard]] LayoutFeature& layouts() const { return *m_layouts; }
    [[nodiscard]] TimelineFeature& timeline() const { return *m_timeline; }
    [[nodiscard]] FindsFeature& finds() const { return *m_features.finds; }
    [[nodiscard]] QString newest() const;  ///< message
    /// What is not to be seen yet; empty: the mission is read through, and its map drawn where it has one.
    [[nodiscard]] QString missing() const;

signals:
    void closing();
    void languageWanted(const QString& code);        ///< for a window made anew
    void registerAgainWanted();                      ///< the mission's scans, anew
    void tidyingWanted(leitstand::MapTidying what);  ///< after which the review is opened again
    void byHandWanted();                             ///< decisions on its map, likewise
    /// The map of this mission and that of @p folder in a new one, which is reviewed then.
    void mergingWanted(const QString& folder);

public slots:
    void showMessage(const QString& text);  ///< as the newest, and keeps it in the list of messages

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void build();
    void addCommands();
    void addByHand();
    void addMerging();
    void askToMerge();
    void connectFeatures();

    ReviewBridge& m_bridge;
    Selection* m_selection;
    CommandTable* m_commands;
    PaneDocks* m_panes;
    RobotsFeature* m_robots = nullptr;
    TimelineFeature* m_timeline = nullptr;
    LayoutFeature* m_layouts = nullptr;
    ReviewClock* m_clock = nullptr;
    PaneFeatures m_features;
    WindowFrame* m_frame = nullptr;
};

}  // namespace leitstand
