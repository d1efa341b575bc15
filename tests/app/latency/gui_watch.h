#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

namespace leitstand::test {

/// Watches how long the GUI thread is away from its events: a timer of 5 ms tells how much later than wanted
/// it comes. What the thread waited for a processor because others had it (/proc/thread-self/schedstat) is
/// counted apart: that is the machine's doing.
class GuiWatch final : public QObject {
public:
    GuiWatch();

    struct Figures {
        std::size_t count = 0;
        double p50 = 0.0, p99 = 0.0, most = 0.0;  ///< [ms]
    };
    /// How long it was away in all.
    [[nodiscard]] Figures wall() const { return figures(m_wall); }
    /// The same without waiting for a processor.
    [[nodiscard]] Figures own() const { return figures(m_own); }
    void clear();

    [[nodiscard]] static Figures figures(std::vector<double> values);

private:
    void look();

    QTimer m_timer;
    std::chrono::steady_clock::time_point m_last;
    std::optional<std::int64_t> m_waited;  ///< for a processor, so far [ns]
    std::vector<double> m_wall, m_own;
};

}  // namespace leitstand::test
