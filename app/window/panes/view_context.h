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

/// What a feature needs that shows robots, live or from a mission's log. All of it outlives the feature.
struct ViewContext {
    MomentSource& source;
    Selection& selection;
    CommandTable& commands;
    PaneDocks& panes;
    QMainWindow& window;
    Station* liveStation = nullptr;  ///< null: there are no live robots that could be sent requests

    /// Shows @p text to the operator, and adds it to the list of messages.
    void notify(const QString& text) const;
};

/// What a feature needs that makes decisions about a map: that of live robots, or of a mission that has
/// ended.
struct MapContext : ViewContext {
    StationMapping& mapping;
};

/// What a feature needs that works with live robots.
struct LiveContext : ViewContext {
    Station& station;
};

/// What a feature needs that works with the log of a mission.
struct ReviewContext : ViewContext {
    ReviewBridge& review;
};

}  // namespace leitstand
