#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "core/event/cloud_sample.h"
#include "core/perception/surroundings/virtual_scan.h"

namespace leitstand::test {

/// An upright box, or a part of one in the air [m].
struct Block {
    Eigen::Vector3d low, high;
};

/// A ramp that rises along x, from 0 at `from` to `height` at `to`, and stays there.
struct Incline {
    double from = 0.0, to = 0.0, height = 0.0;
};

/// Stairs that lead down along x.
struct StairsDown {
    double from = 0.0, riser = 0.0, tread = 0.0;  ///< [m]
};

/// A floor with things on it, and a 3D scanner that turns vertical raw scans of 161 points, 2 degrees apart,
/// once in 2.3 s (RTS/ScanDrive).
struct VirtualWorld {
    std::vector<Block> blocks;
    std::optional<Incline> incline;
    std::optional<StairsDown> stairs;
    double hole = 1e9;    ///< beyond this x the floor is 1 m deeper [m]
    double noise = 0.01;  ///< of a range [m]
    Pose scannerInBase = poseFrom({0.1, 0.0, 0.5}, 0.0, 0.0, 0.0);

    /// Range along a ray; infinite: none.
    [[nodiscard]] double cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
    /// A slice of 0.1 s from @p start on, the scanner looking to 2 pi * t / 2.3 then.
    [[nodiscard]] CloudSample slice(Time start, const BaseInOdomAt& base, std::mt19937& random) const;
};

/// Adds slices from @p from to @p to [s].
void scan(const VirtualWorld& world, VirtualScan& scan, const BaseInOdomAt& base, double from, double to);
[[nodiscard]] Time atSecond(double seconds);
/// A base that stands at @p pose.
[[nodiscard]] BaseInOdomAt standing(const Pose& pose = Pose::Identity());

}  // namespace leitstand::test
