#pragma once

class QMainWindow;

namespace leitstand {

class CommandTable;
class LiveBridge;
class PaneDocks;
class Selection;

/// What a feature of the live window works with; all of it outlives the feature.
struct LiveContext {
    LiveBridge& bridge;
    Selection& selection;
    CommandTable& commands;
    PaneDocks& panes;
    QMainWindow& window;
};

}  // namespace leitstand
