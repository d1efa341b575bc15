#pragma once

#include <functional>

class QMainWindow;

namespace leitstand::test {

/// While @p run shows a window of the program and waits for its end: calls @p look with it once it is shown,
/// and closes it, whatever it would ask. Returns what @p run returns; -1 when no window came within a minute.
[[nodiscard]] int whileOpen(const std::function<int()>& run, const std::function<void(QMainWindow&)>& look);

/// The panes of @p window, which has some.
[[nodiscard]] QMainWindow& panesOf(const QMainWindow& window);

}  // namespace leitstand::test
