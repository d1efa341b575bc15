#pragma once

#include <QObject>
#include <QStringList>

#include "app/window/live/live_context.h"
#include "app/window/view_state.h"

namespace leitstand {

class GoTo;
class MapPane;
class MapView;
struct LiveMoment;

/// The 3D map as it grows ("map"), and how it is looked at.
class MapFeature final : public QObject {
    Q_OBJECT
public:
    MapFeature(const LiveContext& context, const MapViewSettings& view);

    [[nodiscard]] MapView& view() const;
    [[nodiscard]] const MapViewSettings& settings() const { return m_view.settings(); }
    /// What is not to be seen of the map yet.
    [[nodiscard]] QStringList missing() const;

    /// A robot that was not yet sent to a place stays.
    void halt();

signals:
    void told(const QString& text);

private:
    void addCommands();
    void showSummary(const LiveMoment& moment);
    void addRobots();  ///< and what is done with them and their scans

    LiveContext m_context;
    ViewState m_view;
    MapPane* m_pane;
    GoTo* m_going = nullptr;
    bool m_seen = false;
};

}  // namespace leitstand
