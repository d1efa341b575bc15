#include "app/services/victims/victim_watch.h"

#include <chrono>
#include <ctime>
#include <utility>

#include "app/services/log/sequencer.h"
#include "core/event/cloud_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds PicturesEvery(150);  ///< of a camera; thermal pictures are all taken
constexpr std::size_t MostPictures = 40;                 ///< that wait
constexpr std::chrono::milliseconds LongestSilence(500);

std::chrono::nanoseconds threadTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

bool isPicture(const Event& event) {
    return event.sample.is<PictureSample>();
}

/// Whether a search uses @p event at all.
bool isWanted(const Event& event) {
    return isPicture(event) || event.sample.is<OdometrySample>() || event.sample.is<ImuSample>() ||
           event.sample.is<TransformsSample>() || event.sample.is<CloudSample>() ||
           event.sample.is<RangesSample>() || event.sample.is<CameraInfoSample>() ||
           event.sample.is<GasSample>() || event.sample.is<SightingSample>() ||
           event.sample.is<KeyScanSample>() || event.sample.is<ScanPosesSample>() ||
           event.sample.is<RobotPlaceSample>() || event.sample.is<CandidateSample>() ||
           event.sample.is<FindSample>() || event.sample.is<MissionInfoSample>() ||
           event.sample.is<UndoSample>();
}

}  // namespace

VictimWatch::VictimWatch(VictimWatchSetup setup)
    : m_setup(std::move(setup)), m_search(m_setup.robots, m_setup.station) {
    m_search.follow(m_setup.earlierPoses);
    for (const CandidateSample& sample : m_setup.earlier) m_search.restore(sample);
    restoreFinds();
    m_search.setTags(m_setup.tags, m_setup.profile);
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

VictimWatch::~VictimWatch() = default;

void VictimWatch::close() {
    m_thread.request_stop();
    if (m_thread.joinable()) m_thread.join();
}

std::chrono::nanoseconds VictimWatch::worked() const {
    const std::lock_guard lock(m_mutex);
    return m_worked;
}

std::size_t VictimWatch::waiting() const {
    const std::lock_guard lock(m_mutex);
    return m_waiting.size() + m_atWork;
}

void VictimWatch::onEvent(const Event& event) {
    if (!isWanted(event)) return;
    {
        const std::lock_guard lock(m_mutex);
        if (isPicture(event)) {
            Time& last = m_taken[{event.robot, event.sensor}];
            const bool soon = event.role != StreamRole::Thermal && event.received >= last &&
                              event.received - last < PicturesEvery;
            if (soon || m_pictures >= MostPictures) return;
            last = event.received;
            ++m_pictures;
        }
        m_waiting.push_back(event);
    }
    m_came.notify_all();
}

void VictimWatch::locate(LookedAt looked, std::function<void(const std::optional<PlacedCue>&)> answer) {
    ask([looked = std::move(looked), answer = std::move(answer)](VictimSearch& search) {
        answer(search.locate(looked));
    });
}

void VictimWatch::seen(std::vector<Event> pictures, const Eigen::Vector3d& inMap,
                       std::function<void(const std::vector<bool>&)> answer) {
    ask([pictures = std::move(pictures), inMap, answer = std::move(answer)](VictimSearch& search) {
        std::vector<bool> shown;
        for (const Event& picture : pictures) shown.push_back(search.shows(picture, inMap));
        answer(shown);
    });
}

void VictimWatch::ask(Question question) {
    {
        const std::lock_guard lock(m_mutex);
        m_questions.push_back(std::move(question));
    }
    m_came.notify_all();
}

void VictimWatch::restoreFinds() {
    if (!m_setup.finds) return;
    for (const FindSample& find : m_setup.finds()) m_search.restore(find);
}

void VictimWatch::followRobots() {
    const RobotsInMapPtr places = m_setup.places ? m_setup.places() : nullptr;
    if (!places || places == m_places) return;
    m_places = places;
    for (const RobotInMap& one : *places) {
        if (one.placed)
            m_search.correct(one.robot, {one.stamp, one.baseInMap, one.certainty, one.certain, one.how});
    }
}

void VictimWatch::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::deque<Event> taken;
        std::vector<Question> questions;
        {
            std::unique_lock lock(m_mutex);
            m_worked = threadTime();
            m_atWork = 0;
            m_came.wait_for(lock, stop, LongestSilence,
                            [this] { return !m_waiting.empty() || !m_questions.empty(); });
            taken.swap(m_waiting);
            questions.swap(m_questions);
            m_pictures = 0;
            m_atWork = taken.size();
        }
        const bool may = !m_setup.maySearch || m_setup.maySearch();
        for (const Event& event : taken) {
            if (stop.stop_requested()) return;
            if (event.sample.is<UndoSample>()) {
                if (m_setup.poses) m_search.follow(m_setup.poses());
                restoreFinds();
                continue;
            }
            m_search.onEvent(event, may);
        }
        followRobots();
        for (const Question& one : questions) one(m_search);
        if (!may || !m_setup.onCandidate) continue;
        for (const CandidateSample& candidate : m_search.due(stationTime())) m_setup.onCandidate(candidate);
    }
}

}  // namespace leitstand
