#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/mapping/graph/scan_graph.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/motion/scan_cutter.h"
#include "tests/simulation/mapping/recorded_drive.h"
#include "tests/simulation/mapping/trajectory.h"
#include "tests/simulation/mapping/true_surfaces.h"

namespace leitstand::simulation::test {

/// What mapping made of a drive.
struct MappedDrive {
    std::vector<LiveScan> scans;
    std::vector<Localisation> localisations;  ///< one a scan
    LiveMapPtr map;
    Trajectory live;           ///< as mapping put the scans when they came
    Trajectory odometry;       ///< the same scans by odometry alone
    double longest = 0.0;      ///< time for a scan [s]
    std::vector<double> busy;  ///< processor time of each scan, whatever else the computer does [s]
    std::vector<double> solving,
        settling;                    ///< of each time that the map met itself: apart, and on its thread [s]
    std::vector<double> seeking;     ///< of each scan that was looked for in the whole map [s]
    int moves = 0;                   ///< how often scans moved then
    int contradicted = 0;            ///< links of loops that others spoke against
    ScannerCorrection correction;    ///< of the scanner, in the end
    int corrections = 0;             ///< how often it was corrected
    ScannerCalibration calibration;  ///< what the map tells in the end
    ScanGraph graph;                 ///< what the key scans were registered against, as it was said last
};

/// Processor time that this thread took [s].
[[nodiscard]] double processorTime();

/// Cuts scans of what was heard on @p drive and maps them.
[[nodiscard]] std::vector<LiveScan> cutScans(const RecordedDrive& drive,
                                             const ScanCutterSettings& settings = {});
/// The scans of the same drive, as many, with what the scanner says corrected so.
using CorrectedScans = std::function<std::vector<LiveScan>(const ScannerCorrection&)>;
/// @p corrected: given, whoever is asked lets the scanner be corrected whenever the map advises it.
[[nodiscard]] MappedDrive mapped(const RecordedDrive& drive, std::vector<LiveScan> scans,
                                 const LiveSettings& settings = {}, const CorrectedScans& corrected = {});

/// Root mean square distance of the map's points nearer than 6 m to their scanner from true surfaces [m].
/// @p byOdometry: the same scans where odometry alone would put them.
[[nodiscard]] double surfaceError(const MappedDrive& drive, const TrueSurfaces& surfaces, bool byOdometry);
/// The same with the drive's scans where @p trajectory, one pose a scan, puts them.
[[nodiscard]] double surfaceError(const MappedDrive& drive, const TrueSurfaces& surfaces,
                                  const Trajectory& trajectory);

}  // namespace leitstand::simulation::test
