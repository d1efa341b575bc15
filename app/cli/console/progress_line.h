#pragma once

#include <string>

namespace leitstand::cli {

/// One line on stderr that tells how far the work is; silent where stderr is no terminal.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine();  ///< wipes the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Shows @p what and how much of it is done, 0 to 1; at most ten times a second.
    void show(const std::string& what, double fraction);
    /// Shows @p what alone, where nobody knows how much there is to do.
    void show(const std::string& what);
    /// Wipes the line, so that something else can be printed.
    void clear();

private:
    bool m_terminal = false;
    bool m_shown = false;
    long long m_lastMilliseconds = 0;
};

}  // namespace leitstand::cli
