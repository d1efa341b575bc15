#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "app/services/job_queue.h"
#include "core/base/pose.h"
#include "core/mapping/live/loops/submap.h"

namespace leitstand {

/// Computes how a part of the map fits the rest at the place to which the operator drags it, on its own
/// thread. Any thread.
class SubmapFits {
public:
    SubmapFits();
    ~SubmapFits();
    SubmapFits(const SubmapFits&) = delete;
    SubmapFits& operator=(const SubmapFits&) = delete;

    /// Begins to move the key scans @p submap of @p map. They are compared with all other scans except those
    /// in @p left. Drops earlier requests.
    void begin(LiveMapPtr map, std::set<std::uint64_t> submap, std::set<std::uint64_t> left = {});
    void end();  ///< ends the move
    /// Requests how well the submap fits at @p moved (SubmapOnMap::at()). Only the newest request is
    /// computed.
    void want(const Pose& moved);
    /// Requests the pose near @p moved at which the submap fits best (SubmapOnMap::snapped()). Has no effect
    /// while submap() is null.
    void snap(const Pose& moved);

    /// The submap that is moved; null: it is not ready yet, or there is none.
    [[nodiscard]] SubmapOnMapPtr submap() const;
    /// Returns how the submap fits at the newest requested pose that was computed; empty: not known yet.
    [[nodiscard]] std::optional<SubmapFit> fit() const;
    /// The result of snap(), returned once.
    struct Snapped {
        std::optional<Pose> moved;  ///< empty: too little of the submap overlaps with the rest there
    };
    [[nodiscard]] std::optional<Snapped> takeSnapped();

private:
    /// Whether results of run @p run are still valid; under the mutex.
    [[nodiscard]] bool counts(std::uint64_t run) const { return run == m_run; }
    void work();  ///< computes the newest request, unless it is already computing; under the mutex

    mutable std::mutex m_mutex;
    std::uint64_t m_run = 0;  ///< how many times a move was begun or ended
    SubmapOnMapPtr m_submap;
    std::optional<Pose> m_wanted;  ///< requested pose that is not being computed yet
    bool m_works = false;
    std::optional<SubmapFit> m_fit;
    std::optional<Snapped> m_snapped;
    JobQueue m_jobs;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
