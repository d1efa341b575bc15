#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/services/log/event_sink.h"
#include "core/event/event.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mission/coverage/search_view.h"
#include "core/mission/coverage/searched_floor.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What a CoverageWatch needs.
struct CoverageWatchSetup {
    std::vector<RobotDescription> robots;
    std::function<RobotsInMapPtr()> places;        ///< returns where the robots are now, with their trails
    std::function<std::vector<ScanPose>()> poses;  ///< returns the poses of the mission's key scans
    std::vector<KeyScanSample> earlier;            ///< key scans of the mission's earlier sessions
    /// Returns what cameras looked at in earlier sessions. Called on the watch's thread. Must return soon
    /// after a stop is requested. May be empty.
    std::function<std::vector<SearchView>(const std::stop_token&)> earlierViews = {};
    /// Called with a message for the operator when something cannot be included, once for each cause. Called
    /// on the watch's thread or on that of onEvent(). May be empty.
    std::function<void(const std::string&)> notify = {};
};

/// Keeps the searched floor of a running mission up to date, on its own thread. Computes it after changes, at
/// most every two seconds, and less often if that takes long. Leaves out views if it cannot keep up for
/// minutes, or if cameras looked from too many places; then the operator is notified. Any thread.
class CoverageWatch : public EventSink {
public:
    static constexpr std::chrono::seconds Every{2};

    explicit CoverageWatch(CoverageWatchSetup setup);
    ~CoverageWatch() override;

    void onEvent(const Event& event) override;  ///< call with all events of the mission, in order
    void close() override;                      ///< discards waiting events
    /// Returns the searched floor as it was computed last. Null until there is a map with a robot in it.
    [[nodiscard]] SearchedFloorPtr searched() const;

private:
    struct Work;
    [[nodiscard]] bool isTooSoon(const Event& picture);
    void run(const std::stop_token& stop);

    CoverageWatchSetup m_setup;  ///< used by the thread
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Event> m_waiting;
    /// Time of the newest picture, by robot and sensor.
    std::map<std::pair<std::string, std::string>, Time> m_taken;
    std::size_t m_pictures = 0;  ///< number of waiting pictures
    bool m_mentionsPictures = false;
    SearchedFloorPtr m_searched;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
