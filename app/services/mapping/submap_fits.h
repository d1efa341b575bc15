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

/// How a part of the map lies on the rest where the operator drags it to, worked out on a thread beside. Any
/// thread.
class SubmapFits {
public:
    SubmapFits();
    ~SubmapFits();
    SubmapFits(const SubmapFits&) = delete;
    SubmapFits& operator=(const SubmapFits&) = delete;

    /// @p submap of @p map is moved from now on, and compared with the rest without @p left; what was asked
    /// before is dropped.
    void begin(LiveMapPtr map, std::set<std::uint64_t> submap, std::set<std::uint64_t> left = {});
    void end();  ///< nothing is moved any more
    /// It lies at @p moved now (SubmapOnMap::at()): how well that fits is worked out, the newest only.
    void want(const Pose& moved);
    /// It is to snap from there.
    void snap(const Pose& moved);

    /// The submap that is moved; null: it is not made ready yet, or none is.
    [[nodiscard]] SubmapOnMapPtr submap() const;
    /// How it fits where it was wanted last; empty: not known yet.
    [[nodiscard]] std::optional<SubmapFit> fit() const;
    /// What came of snap(), once.
    struct Snapped {
        std::optional<Pose> moved;  ///< empty: too little of it lies on anything there
    };
    [[nodiscard]] std::optional<Snapped> takeSnapped();

private:
    /// Whether what was begun as of number @p run still counts; under the mutex.
    [[nodiscard]] bool counts(std::uint64_t run) const { return run == m_run; }
    void work();  ///< out the newest that is wanted, if nobody is at it; under the mutex

    mutable std::mutex m_mutex;
    std::uint64_t m_run = 0;  ///< times that something was begun or ended
    SubmapOnMapPtr m_submap;
    std::optional<Pose> m_wanted;  ///< that nobody works at yet
    bool m_works = false;
    std::optional<SubmapFit> m_fit;
    std::optional<Snapped> m_snapped;
    JobQueue m_jobs;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
