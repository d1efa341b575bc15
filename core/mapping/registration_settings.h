#pragma once

#include <cstdint>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/filters/voxel_grid.h"
#include "core/cloud/search/search.h"
#include "core/registration/icp.h"

namespace leitstand {

/// Filter for organised scans before the voxel grid.
enum class ScanFilter : std::uint8_t { None, Median };

/// Where the first pose of an alignment comes from.
enum class GuessSource : std::uint8_t {
    /// The odometry's step since the previous scan, applied to that scan's registered pose; no step for scans
    /// without odometry.
    Odometry,
    Identity,  ///< the registered pose of the previous scan
    /// RegistrationSettings::guessPoses relative to the first of them; as Identity for scans beyond its end.
    Poses,
};

/// What a scan is matched against.
enum class Reference : std::uint8_t { Previous, Map };

/// All settings for registering consecutive scans; the defaults of `leitstandctl register`.
struct RegistrationSettings {
    double reduce = 0.10;  ///< edge of a cell of the voxel grid [m]; 0: all points are used
    /// Which point a voxel keeps; Nearest is used after the paper's filter.
    VoxelPoint kept = VoxelPoint::Centroid;
    ScanFilter filter = ScanFilter::None;    ///< the paper's median and reduction filter
    double minRange = 0.4, maxRange = 30.0;  ///< nearer and farther points are left out [m]
    SearchMethod search = SearchMethod::KdTree;
    double epsilon = 0.5;  ///< epsilon of the approximate and forest searches
    Minimizer minimizer = Minimizer::Gicp;
    std::vector<double> maxDistances = {0.5, 0.2, 0.07};  ///< largest distance of a pair, stage by stage [m]
    int maxIterations = 500;  ///< largest number of iterations per scan, over all stages
    GuessSource guess = GuessSource::Odometry;
    std::vector<Pose> guessPoses;  ///< for GuessSource::Poses: one per scan, relative to the first scan
    Reference reference = Reference::Previous;
    int threads = 0;  ///< number of threads; 0: one per core
};

}  // namespace leitstand
