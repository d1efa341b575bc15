#pragma once

class QMainWindow;
class QString;

namespace leitstand {

class CommandTable;
class MomentSource;
class PaneDocks;
class ReviewBridge;
class Selection;
class Station;
class StationMapping;

/// Context of a feature that shows robots, live or from a mission's log. All of it outlives the feature.
struct ViewContext {
    MomentSource& source;
    Selection& selection;
    CommandTable& commands;
    PaneDocks& panes;
    QMainWindow& window;
    Station* liveStation = nullptr;  ///< null: there are no live robots to send requests to

    /// Shows @p text to the operator, and keeps it in the list of messages.
    void notify(const QString& text) const;
};

/// Context of a feature that decides on a map: that of live robots, or of a mission that has ended.
struct MapContext : ViewContext {
    StationMapping& mapping;
};

/// Context of a feature that needs live robots.
struct LiveContext : ViewContext {
    Station& station;
};

/// Context of a feature that needs the log of a mission.
struct ReviewContext : ViewContext {
    ReviewBridge& review;
};

}  // namespace leitstand
