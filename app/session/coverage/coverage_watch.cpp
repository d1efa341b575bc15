#include "app/session/coverage/coverage_watch.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "app/session/coverage/view_search.h"
#include "core/mission/coverage/search_book.h"

namespace leitstand {
namespace {

constexpr std::size_t MostPictures = 200;  ///< that wait
constexpr int Rarely = 20;                 ///< times as long as it took the last time
constexpr std::chrono::milliseconds LongestSilence(500);
constexpr std::chrono::seconds Longest(15);  ///< between two makings, on whatever computer
constexpr double Moved = 0.1;                ///< a robot that did so may reach more [m]

bool isPicture(const Event& event) {
    return std::holds_alternative<PictureSample>(event.sample);
}

ReportScan scanOf(const KeyScanSample& sample) {
    return {.id = sample.id,
            .scan = sample.scan,
            .scanInMap = sample.scanInMap,
            .sensorInBase = sample.sensorInBase};
}

/// Whether the scans lie as they did, as far as a grid of decimetres can tell.
bool alike(const std::vector<ScanPose>& before, const std::vector<ScanPose>& now) {
    return std::equal(before.begin(), before.end(), now.begin(), now.end(), [](const auto& a, const auto& b) {
        return a.scan == b.scan && a.trust == b.trust && distanceBetween(a.scanInMap, b.scanInMap) < 0.02 &&
               angleBetween(a.scanInMap, b.scanInMap) < degrees(0.2);
    });
}

}  // namespace

/// What the thread knows.
struct CoverageWatch::Work {
    using Clock = std::chrono::steady_clock;

    /// @p earlier: key scans of earlier sessions, of which the thinned ones are kept.
    Work(const CoverageWatchSetup& given, const std::vector<KeyScanSample>& earlier,
         const std::stop_token& stop)
        : setup(given), search(given.robots) {
        for (const KeyScanSample& sample : earlier) book.add(scanOf(sample));
        if (setup.earlierViews) {
            for (const SearchView& view : setup.earlierViews(stop)) (void)book.add(view);
        }
        search.follow(setup.poses());
        changed = book.scans() > 0;
    }

    void take(const Event& event) {
        if (const auto* scan = std::get_if<KeyScanSample>(&event.sample)) {
            book.add(scanOf(*scan));
            changed = true;
        }
        search.take(event);
        for (const SearchView& view : search.found()) changed = book.add(view) || changed;
    }

    void followRobots() {
        const RobotsInMapPtr now = setup.places();
        if (!now || now == places) return;
        places = now;
        for (const RobotInMap& one : *now) {
            if (!one.placed) {
                search.lose(one.robot);
                continue;
            }
            search.correct(one.robot, {one.stamp, one.baseInMap, one.certainty, one.certain, one.how});
            // What can be reached, is so from where robots are: they are placed after their first scan is
            // known.
            const auto before = stood.find(one.robot);
            if (before != stood.end() && (before->second - one.baseInMap.translation()).norm() < Moved)
                continue;
            stood.insert_or_assign(one.robot, Eigen::Vector3d(one.baseInMap.translation()));
            changed = true;
        }
    }

    /// What was searched, where it is time to make it anew.
    CoverageMapPtr due() {
        const auto begin = Clock::now();
        if (begin < next || book.scans() == 0) return nullptr;
        std::vector<ScanPose> now = setup.poses();
        if (!changed && alike(poses, now)) {
            next = begin + Every;
            return nullptr;
        }
        poses = std::move(now);
        book.follow(poses);
        search.follow(poses);
        std::vector<Eigen::Vector3d> trail;
        for (const RobotInMap& one : places ? *places : RobotsInMap()) {
            if (!one.placed) continue;
            for (const Eigen::Vector3f& step : *one.trail) trail.push_back(step.cast<double>());
            trail.emplace_back(one.baseInMap.translation());
        }
        if (trail.empty()) return nullptr;  // what can be reached is not known before
        CoverageMapPtr made = book.coverage(trail);
        changed = false;
        const auto took = Clock::now() - begin;
        next = Clock::now() + std::clamp<Clock::duration>(Rarely * took, Every, Longest);
        return made;
    }

    const CoverageWatchSetup& setup;
    ViewSearch search;
    SearchBook book;
    RobotsInMapPtr places;
    std::vector<ScanPose> poses;                   ///< as of the newest coverage
    std::map<std::string, Eigen::Vector3d> stood;  ///< each robot, as of the newest coverage [m]
    bool changed = false;
    Clock::time_point next{};
};

CoverageWatch::CoverageWatch(CoverageWatchSetup setup) : m_setup(std::move(setup)) {
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

CoverageWatch::~CoverageWatch() = default;

void CoverageWatch::end() {
    m_thread.request_stop();
    if (m_thread.joinable()) m_thread.join();
}

CoverageMapPtr CoverageWatch::coverage() const {
    const std::lock_guard lock(m_mutex);
    return m_coverage;
}

void CoverageWatch::take(const Event& event) {
    if (!ViewSearch::wants(event)) return;
    {
        const std::lock_guard lock(m_mutex);
        if (isPicture(event) && m_pictures >= MostPictures) return;
        m_waiting.push_back(event);
        if (isPicture(event)) {
            ++m_pictures;
            std::get<PictureSample>(m_waiting.back().sample).content = {};  // only when it was taken counts
        }
    }
    m_came.notify_all();
}

void CoverageWatch::run(const std::stop_token& stop) {
    Work work(m_setup, std::exchange(m_setup.earlier, {}), stop);
    while (!stop.stop_requested()) {
        std::deque<Event> taken;
        {
            std::unique_lock lock(m_mutex);
            m_came.wait_for(lock, stop, LongestSilence, [this] { return !m_waiting.empty(); });
            taken.swap(m_waiting);
            m_pictures = 0;
        }
        for (const Event& event : taken) {
            if (stop.stop_requested()) return;
            work.take(event);
        }
        work.followRobots();
        if (CoverageMapPtr made = work.due()) {
            const std::lock_guard lock(m_mutex);
            m_coverage = std::move(made);
        }
    }
}

}  // namespace leitstand
