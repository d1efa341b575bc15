#pragma once

#include <filesystem>

namespace leitstand::test {

/// What a sample mission has.
struct SampleMission {
    int scans = 3;          ///< key scans of a furnished room of 8 m x 6 m
    int odometry = 40;      ///< samples, along x
    bool upstairs = false;  ///< as many of one like it, 3 m above, and V4 and Q2 there
    bool finds = true;      ///< V1 confirmed with all evidence, V2 a hypothesis, V3 discarded, H1, Q1, O1
    bool info = true;       ///< competition, team, country, mission
    int victims = 0;        ///< V1 and on, confirmed, over 40 m x 40 m, the first three beside each other
    bool setAside = false;  ///< the operator rejected every scan; their clouds are in the log too
};

/// Writes a mission of Kurt3D as a station would, into @p folder.
void writeSampleMission(const std::filesystem::path& folder, const SampleMission& what = {});

}  // namespace leitstand::test
