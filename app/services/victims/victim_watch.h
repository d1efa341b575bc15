#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/services/log/event_sink.h"
#include "app/services/victims/victim_search.h"
#include "core/event/event.h"
#include "core/event/scan_pose.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What a VictimWatch begins with.
struct VictimWatchSetup {
    std::vector<RobotDescription> robots;
    std::string station;                                      ///< persistent identity
    std::function<bool()> maySearch;                          ///< whether the station has the map's grant
    std::function<void(const CandidateSample&)> onCandidate;  ///< on the watch's thread
    std::function<RobotsInMapPtr()> places;  ///< where the robots are now; empty: only key scans show it
    std::function<std::vector<ScanPose>()> poses;  ///< where the mission's key scans are; used after an undo
    std::function<std::vector<FindSample>()> finds;  ///< in the mission; used after an undo, and at first
    std::vector<ScanPose> earlierPoses;              ///< of the mission's earlier sessions
    std::vector<CandidateSample> earlier;            ///< of the mission's earlier sessions
    TagsOfProfiles tags;                             ///< of victims
    std::string profile;                             ///< score profile that the mission names by now
};

/// VictimSearch on its own thread, live. Any thread. When it cannot keep up, it leaves out pictures (the log
/// has them all), and nothing else.
class VictimWatch : public EventSink {
public:
    explicit VictimWatch(VictimWatchSetup setup);
    ~VictimWatch() override;

    void onEvent(const Event& event) override;  ///< takes all events of the mission, in order
    /// Calls @p answer with the place of what a picture shows, on the watch's thread, after waiting work;
    /// empty: unknown. Does not call it if the watch ends before.
    void locate(LookedAt looked, std::function<void(const std::optional<PlacedCue>&)> answer);
    /// Calls @p answer, in the same way, with a flag for each of @p pictures: whether it shows the place @p
    /// inMap [m].
    void seen(std::vector<Event> pictures, const Eigen::Vector3d& inMap,
              std::function<void(const std::vector<bool>&)> answer);
    void close() override;  ///< drops waiting work; no function is called any more
    [[nodiscard]] std::chrono::nanoseconds worked() const;  ///< processor time so far
    [[nodiscard]] std::size_t waiting() const;              ///< events, with those it works on

private:
    using Camera = std::pair<std::string, std::string>;  ///< robot, sensor
    using Question = std::function<void(VictimSearch&)>;
    void ask(Question question);
    void run(const std::stop_token& stop);
    void followRobots();
    void restoreFinds();

    const VictimWatchSetup m_setup;
    VictimSearch m_search;    ///< of the thread
    RobotsInMapPtr m_places;  ///< as followed last; of the thread
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Event> m_waiting;
    std::vector<Question> m_questions;
    std::map<Camera, Time> m_taken;  ///< newest picture, station's clock
    std::size_t m_pictures = 0;      ///< waiting pictures
    std::size_t m_atWork = 0;        ///< events that were taken and are not done yet
    std::chrono::nanoseconds m_worked{};
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
