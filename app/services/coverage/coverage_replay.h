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

/// A moment of a recorded mission for which the searched floor is wanted.
struct CoverageMoment {
    Time now{};               ///< station's clock
    MissionStatePtr mission;  ///< at that moment
    RobotsInMapPtr places;    ///< at that moment, with the trails
    ReviewIndexPtr index;     ///< of the whole mission
};

/// Computes which floor had been searched at a moment of a recorded mission, on its own thread. Reads the
/// mission once, on the first request. Any thread.
class CoverageReplay {
public:
    explicit CoverageReplay(std::filesystem::path mission);
    ~CoverageReplay();
    CoverageReplay(const CoverageReplay&) = delete;
    CoverageReplay& operator=(const CoverageReplay&) = delete;

    /// Requests the floor searched until @p moment. Only the newest moment counts; a moment with the same
    /// state as the last one costs nothing. None of the pointers in @p moment may be null.
    void want(CoverageMoment moment);
    /// Returns the floor searched until the newest moment that was computed. Null: none was computed yet, or
    /// there was no map, or no robot in it.
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
