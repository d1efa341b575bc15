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

/// A moment of a recorded mission for which the searched floor is requested.
struct CoverageMoment {
    Time now{};               ///< time of that moment, station's clock
    MissionStatePtr mission;  ///< state at that moment
    RobotsInMapPtr places;    ///< robots at that moment, with their trails
    ReviewIndexPtr index;     ///< index of the whole mission
};

/// Computes, on its own thread, which floor had been searched at a moment of a recorded mission. Reads the
/// mission once, at the first request. Any thread.
class CoverageReplay {
public:
    explicit CoverageReplay(std::filesystem::path mission);
    ~CoverageReplay();
    CoverageReplay(const CoverageReplay&) = delete;
    CoverageReplay& operator=(const CoverageReplay&) = delete;

    /// Requests the floor searched until @p moment. Only the newest request is computed; a moment with the
    /// same state as the last one costs nothing. None of the pointers in @p moment may be null.
    void want(CoverageMoment moment);
    /// Returns the floor searched until the newest computed moment. Null: none was computed yet, or there was
    /// no map, or no robot in it.
    [[nodiscard]] SearchedFloorPtr searched() const;

private:
    struct Work;
    void run(const std::stop_token& stop);

    const std::filesystem::path m_mission;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::optional<CoverageMoment> m_wanted;
    SearchedFloorPtr m_searched;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
