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

/// What a feature that shows robots works with, live or from a mission's log. All of it outlives the feature.
struct ViewContext {
    MomentSource& source;
    Selection& selection;
    CommandTable& commands;
    PaneDocks& panes;
    QMainWindow& window;
    Station* liveStation = nullptr;  ///< null: there are no live robots, and nothing can be asked of them

    /// Shows @p text to the operator, and keeps it in the list of messages.
    void notify(const QString& text) const;
};

/// What a feature that decides on a map works with: that of live robots, or of a mission that has ended.
struct MapContext : ViewContext {
    StationMapping& mapping;
};

/// What a feature works with that needs live robots.
struct LiveContext : ViewContext {
    Station& station;
};

/// What a feature works with that needs the log of a mission.
struct ReviewContext : ViewContext {
    ReviewBridge& review;
};

}  // namespace leitstand
