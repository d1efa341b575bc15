#include "app/services/coverage/coverage_watch.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "app/services/coverage/searched_scans.h"
#include "app/services/coverage/view_search.h"
#include "core/base/words.h"
#include "core/event/map_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/scan_pose.h"
#include "core/mission/coverage/search_book.h"

namespace leitstand {
namespace {

constexpr std::size_t MostPictures = 30'000;  ///< that wait, without their content
constexpr int Rarely = 20;                    ///< times the duration of the last computation
constexpr std::chrono::milliseconds LongestSilence(500);
constexpr std::chrono::seconds Longest(30);  ///< between two computations, on any computer
constexpr double Moved = 0.1;                ///< a robot that moved this far may reach more [m]

bool isPicture(const Event& event) {
    return event.sample.is<PictureSample>();
}

/// Whether the scans lie where they did, as far as a grid of decimetres resolves it.
bool alike(const std::vector<ScanPose>& before, const std::vector<ScanPose>& now) {
    return std::equal(before.begin(), before.end(), now.begin(), now.end(), [](const auto& a, const auto& b) {
        return a.scan == b.scan && a.trust == b.trust && distanceBetween(a.scanInMap, b.scanInMap) < 0.02 &&
               angleBetween(a.scanInMap, b.scanInMap) < degrees(0.2);
    });
}

}  // namespace

/// State of the thread.
struct CoverageWatch::Work {
    using Clock = std::chrono::steady_clock;

    /// @p earlier: key scans of earlier sessions; only thinned copies of them are kept.
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

    void onEvent(const Event& event) {
        if (const auto* scan = event.sample.as<KeyScanSample>()) {
            book.add(scanOf(*scan));
            changed = true;
        }
        search.onEvent(event);
        for (const SearchView& view : search.found()) changed = book.add(view) || changed;
        if (book.leftOut() == 0 || notified || !setup.notify) return;
        notified = true;
        setup.notify(translate("leitstand::Station",
                               "Cameras looked from more places than can be kept: what they look at from now "
                               "on may not count as searched"));
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
            // Reach starts from where robots are, and they are placed after their first scan is known.
            const auto before = stood.find(one.robot);
            if (before != stood.end() && (before->second - one.baseInMap.translation()).norm() < Moved)
                continue;
            stood.insert_or_assign(one.robot, Eigen::Vector3d(one.baseInMap.translation()));
            changed = true;
        }
    }

    /// Returns what was searched when a new computation is due, else null.
    SearchedFloorPtr due() {
        const auto begin = Clock::now();
        if (begin < next || book.scans() == 0) return nullptr;
        std::vector<ScanPose> now = setup.poses();
        if (!changed && alike(poses, now)) {
            next = begin + Every;
            return nullptr;
        }
        const std::vector<Eigen::Vector3d> trail = trailsOf(places ? *places : RobotsInMap());
        if (trail.empty()) {  // reach is unknown before
            next = begin + Every;
            return nullptr;
        }
        poses = std::move(now);
        book.follow(poses);
        search.follow(poses);
        SearchedFloorPtr made = searchedFloorOf(book.byStorey(trail));
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
    bool changed = false, notified = false;
    Clock::time_point next{};
};

CoverageWatch::CoverageWatch(CoverageWatchSetup setup) : m_setup(std::move(setup)) {
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

CoverageWatch::~CoverageWatch() = default;

void CoverageWatch::close() {
    m_thread.request_stop();
    if (m_thread.joinable()) m_thread.join();
}

SearchedFloorPtr CoverageWatch::searched() const {
    const std::lock_guard lock(m_mutex);
    return m_searched;
}

/// Whether a picture of its camera was taken shortly before: cameras send more pictures than are looked at.
bool CoverageWatch::isTooSoon(const Event& picture) {
    Time& last = m_taken[{picture.robot, picture.sensor}];
    // Only half of it: the network makes gaps uneven.
    if (picture.received >= last && picture.received - last < ViewFinder::Every / 2) return true;
    last = picture.received;
    return false;
}

void CoverageWatch::onEvent(const Event& event) {
    if (!ViewSearch::wants(event)) return;
    const bool picture = isPicture(event);
    {
        const std::lock_guard lock(m_mutex);
        if (picture && isTooSoon(event)) return;
        if (!picture || m_pictures < MostPictures) {
            m_waiting.push_back(event);
            if (picture) {
                ++m_pictures;
                auto* const kept = m_waiting.back().sample.edit<PictureSample>();
                kept->content = {};  // only its time counts
                kept->video = nullptr;
            }
            return m_came.notify_all();
        }
        if (std::exchange(m_mentionsPictures, true)) return;
    }
    if (m_setup.notify) {
        m_setup.notify(translate(
            "leitstand::Station",
            "This computer is too slow for all that cameras look at: some of it does not count as searched"));
    }
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
            work.onEvent(event);
        }
        work.followRobots();
        if (SearchedFloorPtr made = work.due()) {
            const std::lock_guard lock(m_mutex);
            m_searched = std::move(made);
        }
    }
}

}  // namespace leitstand
