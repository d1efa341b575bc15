#pragma once

#include "tests/simulation/mapping/mapped_drive.h"

namespace leitstand::simulation::test {

/// How well a map met itself on a drive.
struct LoopScore {
    int links = 0;     ///< of loops that are active at the end
    int wrong = 0;     ///< of those, more than 0.3 m or 3 degrees off
    int asked = 0;     ///< links of which the operator is asked
    int misled = 0;    ///< of those, as much off
    int revisits = 0;  ///< times that the robot came to where it was more than 20 m of way before
    /// Of those, where its scans hang together with those of then after 10 m more at most, or it is asked,
    /// rightly, whether they do.
    int closed = 0;
};
[[nodiscard]] LoopScore loopScore(const MappedDrive& mapped, const RecordedDrive& drive);

}  // namespace leitstand::simulation::test
