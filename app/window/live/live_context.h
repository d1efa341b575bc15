#pragma once

class QMainWindow;

namespace leitstand {

class CommandTable;
class LiveBridge;
class MomentSource;
class PaneDocks;
class Selection;
class Station;
class StationMapping;

/// What a feature that shows robots works with, live ones or those of a mission's log; all of it outlives the
/// feature.
struct ViewContext {
    MomentSource& source;
    Selection& selection;
    CommandTable& commands;
    PaneDocks& panes;
    QMainWindow& window;
    Station* station = nullptr;  ///< null: there are no live robots, and nothing can be asked of them
};

/// What a feature that decides on a map works with: that of live robots, or of a mission that has ended.
struct MapContext : ViewContext {
    StationMapping& mapping;
};

/// What a feature that has to do with live robots works with.
struct LiveContext : ViewContext {
    LiveBridge& bridge;
};

}  // namespace leitstand
