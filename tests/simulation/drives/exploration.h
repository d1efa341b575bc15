#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/simulation/drives/driven_world.h"
#include "tests/simulation/drives/seen_floor.h"

namespace leitstand::simulation::test {

/// A victim that can be found by its heat: warm, not hidden.
struct WarmVictim {
    std::string name;
    double reportedAt = -1.0;  ///< by the robot [s]; negative: not
    double off = 0.0;          ///< of the reported place from the victim's box [m]
};

/// What came of exploring.
struct Exploration {
    double seconds = 0.0;
    double seen = 0.0;  ///< share of the reachable floor
    std::vector<WarmVictim> victims;
    int falseReports = 0;  ///< sightings where nothing warm and alive is
    int bumps = 0;
    std::string ended;  ///< why it stopped before its time; empty: it did not
    [[nodiscard]] int found() const;
};

/// Lets Kurt3D explore for @p seconds. Its operator only looks at what it reports: after each victim the
/// robot waits, and is sent on after 2 s. @p watch is called ten times a second.
[[nodiscard]] Exploration explore(DrivenWorld& driven, SeenFloor& floor, double seconds,
                                  const std::function<void()>& watch = {});

}  // namespace leitstand::simulation::test
