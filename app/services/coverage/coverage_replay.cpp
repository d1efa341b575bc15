#include "app/services/coverage/coverage_replay.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "app/services/coverage/logged_views.h"
#include "app/services/coverage/searched_scans.h"
#include "app/services/places/mission_map.h"
#include "core/event/scan_pose.h"
#include "core/mission/coverage/search_book.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

/// What a result was made from.
struct Made {
    std::vector<ScanPose> poses;
    std::size_t views = 0;  ///< seen by then
    std::size_t steps = 0;  ///< of the trails
};

bool alike(const Made& one, const Made& other) {
    return one.views == other.views && one.steps == other.steps &&
           std::equal(one.poses.begin(), one.poses.end(), other.poses.begin(), other.poses.end(),
                      [](const ScanPose& a, const ScanPose& b) {
                          return a.scan == b.scan && a.trust == b.trust &&
                                 a.scanInMap.matrix() == b.scanInMap.matrix();
                      });
}

}  // namespace

/// State of the thread.
struct CoverageReplay::Work {
    Work(const std::filesystem::path& mission, const ReviewIndex& index, const std::stop_token& stop) {
        for (const auto& [id, sample] : index.keyScans) {
            if (stop.stop_requested()) return;
            book.add(scanOf(sample));
        }
        for (const SearchView& view : loggedViews(mission, {.report = {}, .stop = stop}).views) {
            (void)book.add(view);
            seen.push_back(view.seen);
        }
        std::sort(seen.begin(), seen.end());
    }

    /// Returns what was searched by @p moment; empty: nothing changed.
    std::optional<SearchedFloorPtr> at(const CoverageMoment& moment) {
        const std::vector<Eigen::Vector3d> trails = trailsOf(*moment.places);
        const auto views = std::upper_bound(seen.begin(), seen.end(), moment.now) - seen.begin();
        Made now{posesOf(*moment.mission), static_cast<std::size_t>(views), trails.size()};
        if (made && alike(*made, now)) return std::nullopt;
        made = std::move(now);
        if (trails.empty() || made->poses.empty()) return SearchedFloorPtr();
        book.follow(made->poses);
        return searchedFloorOf(book.byStorey(trails, moment.now));
    }

    SearchBook book;
    std::vector<Time> seen;  ///< time of each view, ascending
    std::optional<Made> made;
};

CoverageReplay::CoverageReplay(std::filesystem::path mission) : m_mission(std::move(mission)) {
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

CoverageReplay::~CoverageReplay() = default;

void CoverageReplay::want(CoverageMoment moment) {
    {
        const std::lock_guard lock(m_mutex);
        m_wanted = std::move(moment);
    }
    m_came.notify_all();
}

SearchedFloorPtr CoverageReplay::searched() const {
    const std::lock_guard lock(m_mutex);
    return m_searched;
}

void CoverageReplay::run(const std::stop_token& stop) {
    std::optional<Work> work;
    while (true) {
        CoverageMoment moment;
        {
            std::unique_lock lock(m_mutex);
            if (!m_came.wait(lock, stop, [this] { return m_wanted.has_value(); })) return;
            moment = std::move(*std::exchange(m_wanted, std::nullopt));
        }
        if (!work) work.emplace(m_mission, *moment.index, stop);
        if (stop.stop_requested()) return;
        const auto begin = std::chrono::steady_clock::now();
        auto made = work->at(moment);
        if (!made) continue;
        std::unique_lock lock(m_mutex);
        m_searched = std::move(*made);
        // While a mission is played, each moment differs from the last.
        m_came.wait_for(lock, stop, 2 * (std::chrono::steady_clock::now() - begin), [] { return false; });
    }
}

}  // namespace leitstand
