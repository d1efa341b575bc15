#pragma once

#include <string>

namespace leitstand::cli {

/// One line on stderr that shows the progress of the work. Prints nothing if stderr is no terminal.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine();  ///< clears the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Shows @p what and the @p fraction of the work that is done, 0 to 1. Updates at most ten times a
    /// second.
    void show(const std::string& what, double fraction);
    /// Shows only @p what, if the amount of work is unknown.
    void show(const std::string& what);
    /// Clears the line, so that something else can be printed.
    void clear();

private:
    bool m_terminal = false;
    bool m_shown = false;
    long long m_lastMilliseconds = 0;
};

}  // namespace leitstand::cli
