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
    Odometry,  ///< the odometry's step since the previous scan, on top of that scan's registered pose;
               ///< identity step for scans without odometry
    Identity,  ///< the registered pose of the previous scan
    Poses,     ///< RegistrationSettings::guessPoses, relative to the first of them; for scans beyond, as
               ///< Identity
};

/// What a scan is matched against.
enum class Reference : std::uint8_t { Previous, Map };

/// All settings for registering a row of scans; the defaults of `leitstandctl register`.
struct RegistrationSettings {
    double reduce = 0.10;                    ///< edge of the voxel grid, 0: all points [m]
    VoxelPoint kept = VoxelPoint::Centroid;  ///< point of a voxel; after the paper's filter: Nearest
    ScanFilter filter = ScanFilter::None;    ///< the paper's median and reduction filter
    double minRange = 0.4, maxRange = 30.0;  ///< nearer and farther points are left out [m]
    SearchMethod search = SearchMethod::KdTree;
    double epsilon = 0.5;  ///< of approximate and forest search
    Minimizer minimizer = Minimizer::Gicp;
    std::vector<double> maxDistances = {0.5, 0.2, 0.07};  ///< schedule of maximum pair distances [m]
    int maxIterations = 500;                              ///< per scan, over all stages
    GuessSource guess = GuessSource::Odometry;
    std::vector<Pose> guessPoses;  ///< for GuessSource::Poses: scan in first scan, one per scan
    Reference reference = Reference::Previous;
    int threads = 0;  ///< 0: one per core
};

}  // namespace leitstand
