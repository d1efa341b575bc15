#pragma once

#include <chrono>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/robots/robot_process.h"

namespace leitstand::test {

/// A station that is a process and holds the stick: it drives "kurt3d" to and fro, and never lets go by
/// itself.
class HeldStation {
public:
    /// @p more: as of the program held_station.
    HeldStation(const std::filesystem::path& folder, const TestDomain& domain, double speed,
                std::vector<std::string> more = {});

    /// Waits until it says that the robot drives, and that at the truth's word it does.
    [[nodiscard]] bool drives() const;
    void turn();  ///< lets the stick go and pulls it the other way
    void signal(int number) const { m_process.signal(number); }
    int wait() { return m_process.wait(); }
    [[nodiscard]] pid_t id() const { return m_process.id(); }
    [[nodiscard]] std::string out() const { return m_process.out(); }

private:
    [[nodiscard]] int reported() const;  ///< how often it said that it drives
    int m_awaited = 1;
    ChildProcess m_process;
};

/// How fast a robot truly is, in all that was told since the test began.
class TrueSpeed {
public:
    using Clock = std::chrono::system_clock;  ///< that samples are stamped with when they are complete here

    /// Of "kurt3d" in an arena called @p arena.
    TrueSpeed(const TestDomain& domain, const std::string& arena);

    [[nodiscard]] double now() const;  ///< [m/s]; 0 before the first
    /// When it stood, for good, after @p moment: the first sample of those at its end at which it stands [s
    /// after
    /// @p moment]. Empty: it moves still, or nothing came since.
    [[nodiscard]] std::optional<double> stoodAfter(Time moment) const;
    /// The longest time between two samples since @p moment, of which 50 a second come [s]: a longer one
    /// means that the robot's own computer, or this one, was busy with something else.
    [[nodiscard]] double longestGapSince(Time moment) const;
    /// The fastest since @p moment [m/s].
    [[nodiscard]] double fastestSince(Time moment) const;

    static constexpr double Standing = 0.01;  ///< slower [m/s]

private:
    std::unique_ptr<Node> m_node;
    mutable std::mutex m_mutex;
    std::deque<std::pair<Time, double>> m_speeds;
    std::unique_ptr<Subscription> m_listening;  ///< last: it calls back
};

}  // namespace leitstand::test
