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

/// Computes what was searched by a moment of a recorded mission, on its own thread. Reads the mission once,
/// on the first request. Any thread.
class CoverageReplay {
public:
    explicit CoverageReplay(std::filesystem::path mission);
    ~CoverageReplay();
    CoverageReplay(const CoverageReplay&) = delete;
    CoverageReplay& operator=(const CoverageReplay&) = delete;

    /// Requests what was searched by @p moment. Only the newest moment counts; a moment with the same state
    /// as the last one costs nothing. None of its pointers is null.
    void want(CoverageMoment moment);
    /// What was searched by the newest finished moment; null before the first, and when there is no map.
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
