#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "app/services/recorded/review_index.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mission/coverage/searched_floor.h"

namespace leitstand {

/// A moment of a recorded mission that somebody wants to know of what was searched by then.
struct CoverageMoment {
    Time now{};               ///< station's clock
    MissionStatePtr mission;  ///< then
    RobotsInMapPtr places;    ///< then, with the trails
    ReviewIndexPtr index;     ///< of the whole mission
};

/// What was searched by a moment of a recorded mission, on a thread of its own that reads the mission once
/// when it is asked first. Any thread.
class CoverageReplay {
public:
    explicit CoverageReplay(std::filesystem::path mission);
    ~CoverageReplay();
    CoverageReplay(const CoverageReplay&) = delete;
    CoverageReplay& operator=(const CoverageReplay&) = delete;

    /// Only the newest moment counts; one at which all was as at the one before costs nothing. None of its
    /// pointers is null.
    void want(CoverageMoment moment);
    /// As of the newest moment that is done; null before the first, and where there is no map.
    [[nodiscard]] SearchedFloorPtr searched() const;

private:
    struct Work;
    void run(const std::stop_token& stop);

    const std::filesystem::path m_mission;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::optional<CoverageMoment> m_wanted;
    SearchedFloorPtr m_searched;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
