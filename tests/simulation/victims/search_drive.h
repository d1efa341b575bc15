#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/services/places/frame_tracks.h"
#include "app/services/victims/victim_search.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/motion/scan_cutter.h"
#include "tests/simulation/drives/driven_world.h"

namespace leitstand::simulation::test {

/// What is true of a victim, and what came of it.
struct VictimTruth {
    int element = 0;  ///< number in the arena
    bool warm = false, hidden = false;
    int looks = 0;     ///< infrared pictures in which its skin was, from nearer than 4 m
    int tagLooks = 0;  ///< pictures of the left camera in which its tag was large enough to be read
    /// Whether it was to be found: by its warmth, or, where it is cold, by its tag.
    [[nodiscard]] bool isAsked() const;
};

/// A robot in an arena whose samples are mapped and searched for victims as at a station, in one process.
class SearchDrive {
public:
    SearchDrive(const Arena& arena, const DriveSetup& setup);

    DrivenWorld driven;
    std::unique_ptr<VictimSearch> search;
    std::map<std::uint32_t, CandidateSample> candidates;  ///< newest by id
    std::map<std::uint32_t, CandidateSample> stood;       ///< as each stood last, also those taken back
    std::vector<VictimTruth> victims;
    std::function<void(const Event&)> onEvent;  ///< told of all that the search is given; may be empty
    int updates = 0;                            ///< of candidates
    std::chrono::nanoseconds worked{};          ///< time of searching

    /// Where the map lies in the arena, by its first scan.
    [[nodiscard]] const Pose& mapInArena() const { return m_mapInArena; }

private:
    void receive(const HardwareSample& sample);
    void map(const Event& event);
    void give(const Event& event);
    void look(const Event& event);
    void lookForSkin(const Pose& camera);
    void lookForTags(const Pose& camera);
    [[nodiscard]] Event eventOf(const HardwareSample& sample);

    RobotDescription m_robot;
    ScanCutter m_cutter;
    LiveMapper m_mapper;
    FrameTracks m_frames;
    Pose m_mapInArena = Pose::Identity();
    bool m_mapped = false;
    std::uint64_t m_sequence = 0;
    Time m_due{};
};

/// Distance of @p place from the body of victim @p element, from above [m].
[[nodiscard]] double fromBody(const Element& element, const Eigen::Vector3d& place);

/// How well the search did.
struct SearchResult {
    int lookedAt = 0, found = 0, falseOnes = 0, codes = 0, codesWrong = 0, hazards = 0, hazardsWrong = 0;
    int coldLookedAt = 0, coldFound = 0;  ///< of these, cold ones whose tags were looked at
    int falseEver = 0;   ///< candidates that were told beside no victim, also those taken back
    double worst = 0.0;  ///< of those found [m]
};
/// Compares with the truth and prints a table.
[[nodiscard]] SearchResult judge(const SearchDrive& drive, const std::string& title);

}  // namespace leitstand::simulation::test
