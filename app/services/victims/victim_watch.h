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

/// What a VictimWatch needs.
struct VictimWatchSetup {
    std::vector<RobotDescription> robots;
    std::string station;              ///< persistent identity
    std::function<bool()> maySearch;  ///< returns whether the station has the map's grant
    std::function<void(const CandidateSample&)> onCandidate;  ///< called on the watch's thread
    /// Returns where the robots are now; empty: only key scans show it.
    std::function<RobotsInMapPtr()> places;
    /// Returns the poses of the mission's key scans; used after an undo.
    std::function<std::vector<ScanPose>()> poses;
    /// Returns the finds in the mission; used after an undo, and at first.
    std::function<std::vector<FindSample>()> finds;
    std::vector<ScanPose> earlierPoses;    ///< poses from the mission's earlier sessions
    std::vector<CandidateSample> earlier;  ///< candidates from the mission's earlier sessions
    TagsOfProfiles tags;                   ///< which codes are tags of victims
    std::string profile;                   ///< score profile that the mission names at present
};

/// VictimSearch on its own thread, live. Any thread. If it is too slow, it leaves out pictures (the log has
/// all of them), but nothing else.
class VictimWatch : public EventSink {
public:
    explicit VictimWatch(VictimWatchSetup setup);
    ~VictimWatch() override;

    void onEvent(const Event& event) override;  ///< takes all events of the mission, in order
    /// Calls @p answer with the place of what a picture shows, on the watch's thread, after waiting work;
    /// empty: unknown. If the watch ends before that, it is not called.
    void locate(LookedAt looked, std::function<void(const std::optional<PlacedCue>&)> answer);
    /// Calls @p answer, in the same way, with a flag for each of @p pictures: whether it shows the place
    /// @p inMap [m].
    void seen(std::vector<Event> pictures, const Eigen::Vector3d& inMap,
              std::function<void(const std::vector<bool>&)> answer);
    void close() override;  ///< discards waiting work; afterwards no function is called
    [[nodiscard]] std::chrono::nanoseconds worked() const;  ///< processor time used so far
    [[nodiscard]] std::size_t waiting() const;  ///< number of waiting events, including those in progress

private:
    using Camera = std::pair<std::string, std::string>;  ///< robot, sensor
    using Question = std::function<void(VictimSearch&)>;
    void ask(Question question);
    void run(const std::stop_token& stop);
    void followRobots();
    void restoreFinds();

    const VictimWatchSetup m_setup;
    VictimSearch m_search;    ///< used by the thread
    RobotsInMapPtr m_places;  ///< places that were last used; used by the thread
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Event> m_waiting;
    std::vector<Question> m_questions;
    std::map<Camera, Time> m_taken;  ///< time of the newest picture, station's clock
    std::size_t m_pictures = 0;      ///< number of waiting pictures
    std::size_t m_atWork = 0;        ///< number of events that were taken and are not finished yet
    std::chrono::nanoseconds m_worked{};
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
