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

/// The window for a recorded mission (docs/design.md, "The window"): the live window's panes, and below them
/// the timeline, which they follow. It only combines features.
class ReviewWindow final : public QMainWindow {
    Q_OBJECT
public:
    ReviewWindow(ReviewBridge& bridge, const MapViewSettings& view, LayoutBook layouts = {},
                 QWidget* parent = nullptr);
    ~ReviewWindow() override;

    [[nodiscard]] MapView& mapView() const;
    /// Returns the present view of the map, to be stored. Its look is the operator's own, not that of the
    /// layout.
    [[nodiscard]] MapViewSettings view() const;
    void setLook(MapLook look);  ///< look of the map, in the present layout
    [[nodiscard]] Selection& selection() const { return *m_selection; }
    [[nodiscard]] CommandTable& commands() const { return *m_commands; }
    [[nodiscard]] PaneDocks& panes() const { return *m_panes; }
    [[nodiscard]] LayoutFeature& layouts() const { return *m_layouts; }
    [[nodiscard]] TimelineFeature& timeline() const { return *m_timeline; }
    [[nodiscard]] FindsFeature& finds() const { return *m_features.finds; }
    [[nodiscard]] QString newest() const;  ///< newest message
    /// Returns texts about what is not visible yet. Empty when three things are done: the mission is
    /// completely read, its map is drawn (if it has one), and a camera pane shows a picture (if there is
    /// one).
    [[nodiscard]] QString missing() const;

signals:
    void closing();
    void languageWanted(const QString& code);  ///< requests a new window in this language
    void registerAgainWanted();                ///< the mission's scans shall be registered again
    /// The map shall be tidied, or this undone; then the review opens again.
    void tidyingWanted(leitstand::MapTidying what);
    void byHandWanted();  ///< the map shall be corrected by hand; then the review opens again
    /// The map shall be merged with that of the mission @p folder into a new mission, which is then reviewed.
    void mergingWanted(const QString& folder);

public slots:
    void showMessage(const QString& text);  ///< as the newest message; also adds it to the list of messages

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
