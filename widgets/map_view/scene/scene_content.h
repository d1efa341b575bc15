#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "widgets/map_view/scene/points/map_colours.h"
#include "widgets/map_view/scene/points/point_paint.h"
#include "widgets/map_view/scene/points/scan_points.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// A scan as it is drawn.
struct SceneScan {
    std::string name;
    std::string robot;        ///< the robot that took it
    std::size_t robotAt = 0;  ///< in SceneContent::robots
    Time entered{};           ///< MapScan::entered
    double age = 0.0;         ///< since the first scan; in the unit of SceneContent::ages
    std::uint64_t id = 0;     ///< MapScan::id
    bool uncertain = false;
    Pose poseInMap = Pose::Identity();  ///< the pose shown: registered or guessed
    bool visible = true;
    ScanPointsPtr points;                ///< null until made ready
    std::optional<PointCloudLook> look;  ///< empty until made ready, and while voxels are shown
};

/// The exposed faces of the occupied voxels; colours carry the shading.
struct VoxelMesh {
    std::vector<Eigen::Vector3f> vertices;  ///< in the map's frame [m]
    std::vector<Rgba> colours;              ///< one per vertex
    std::vector<std::int32_t> triangles;    ///< three vertices each, counter-clockwise from outside
    std::size_t voxels = 0;
};

/// A robot as the map's colours and legend show it.
struct SceneRobot {
    std::string name, title;
    int place = -1;           ///< in the team, selects its colour; negative: not in the team
    std::string letter = {};  ///< may be empty

    bool operator==(const SceneRobot&) const = default;
};

/// The unit of SceneScan::age.
enum class SceneAges : std::uint8_t {
    Minutes,
    Scans,  ///< order of the scans, when times are unknown
};

/// Everything that a picture of the map shows, except the camera. Immutable once shared.
struct SceneContent {
    std::uint64_t order = 0;  ///< number of the SceneOrder this answers
    bool complete = true;     ///< false while scans are still being made ready
    MapViewSettings settings;
    std::vector<SceneScan> scans;  ///< as in Map::scans
    /// Drawn besides the map: scans at poses they might get, new things and gone things.
    std::vector<SceneScan> ghosts;
    bool moves = false;                       ///< some ghosts are scans at poses they might get
    bool dragged = false;                     ///< these are scans that the operator drags
    bool changes = false;                     ///< changes are shown: all else is dimmed()
    std::shared_ptr<const VoxelMesh> voxels;  ///< only in the voxel look
    std::vector<SceneRobot> robots;           ///< robots that took the scans, and others of the team
    SceneAges ages = SceneAges::Minutes;
    std::uint64_t inQuestion = 0;         ///< id of the uncertain scan to be decided on; 0: none
    std::optional<ColourRamp> ramp;       ///< set when coloured by a number
    std::vector<Eigen::Vector3d> places;  ///< what a camera should frame, in the map's frame [m]

    /// Whether ceilings are drawn; never while changes are shown, which they would hide.
    [[nodiscard]] bool withCeiling() const { return settings.withCeiling() && !changes; }
};
using SceneContentPtr = std::shared_ptr<const SceneContent>;

}  // namespace leitstand
