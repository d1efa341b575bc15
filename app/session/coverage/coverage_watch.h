#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/mapping/live/robot_in_map.h"
#include "core/mission/coverage/coverage_map.h"
#include "core/mission/event.h"

namespace leitstand {

/// What a CoverageWatch begins with.
struct CoverageWatchSetup {
    std::vector<RobotDescription> robots;
    std::function<RobotsInMapPtr()> places;        ///< where the robots are now, with their trails
    std::function<std::vector<ScanPose>()> poses;  ///< where the mission's key scans are
    std::vector<KeyScanSample> earlier;            ///< key scans of the mission's earlier sessions
    /// What cameras looked at in earlier sessions; called on the watch's thread, returns soon when it is
    /// asked to stop. May be empty.
    std::function<std::vector<SearchView>(const std::stop_token&)> earlierViews = {};
};

/// Keeps what was searched while a mission runs, on a thread of its own: made anew when something changed, at
/// most every two seconds, and more rarely where that takes long. Any thread. Where it
/// cannot keep up, pictures are left out.
class CoverageWatch {
public:
    static constexpr std::chrono::seconds Every{2};

    explicit CoverageWatch(CoverageWatchSetup setup);
    ~CoverageWatch();
    CoverageWatch(const CoverageWatch&) = delete;
    CoverageWatch& operator=(const CoverageWatch&) = delete;

    void take(const Event& event);  ///< all events of the mission, in order
    void end();                     ///< what waits is left
    /// What was searched, as made last; null until there is a map.
    [[nodiscard]] CoverageMapPtr coverage() const;

private:
    struct Work;
    void run(const std::stop_token& stop);

    CoverageWatchSetup m_setup;  ///< of the thread
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Event> m_waiting;
    std::size_t m_pictures = 0;  ///< that wait
    CoverageMapPtr m_coverage;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
