#pragma once

class QDialog;

namespace leitstand {

class PaneDocks;

/// Shows @p dialog, in front of all. If it was hidden, it is placed over the panes but not over the bar, so
/// that STOP stays in sight.
void showOverPanes(QDialog& dialog, const PaneDocks& panes);

}  // namespace leitstand
