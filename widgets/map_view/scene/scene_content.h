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
    std::size_t robotAt = 0;  ///< index in SceneContent::robots
    Time entered{};           ///< MapScan::entered
    double age = 0.0;         ///< since the first scan, in the unit of SceneContent::ages
    std::uint64_t id = 0;     ///< MapScan::id
    bool uncertain = false;
    Pose poseInMap = Pose::Identity();  ///< pose that is shown: registered or guessed
    bool visible = true;
    ScanPointsPtr points;                ///< null until it is prepared
    std::optional<PointCloudLook> look;  ///< empty until it is prepared, and while voxels are shown
};

/// The visible faces of the occupied voxels. Their colours include the shading.
struct VoxelMesh {
    std::vector<Eigen::Vector3f> vertices;  ///< in the map's frame [m]
    std::vector<Rgba> colours;              ///< one per vertex
    std::vector<std::int32_t> triangles;    ///< three vertices each, counter-clockwise seen from outside
    std::size_t voxels = 0;
};

/// A robot as it appears in the map's colours and legend.
struct SceneRobot {
    std::string name, title;
    int place = -1;           ///< place in the team, which determines its colour; negative: not in the team
    std::string letter = {};  ///< may be empty

    bool operator==(const SceneRobot&) const = default;
};

/// The unit of SceneScan::age.
enum class SceneAges : std::uint8_t {
    Minutes,
    Scans,  ///< number of scans, if their times are unknown
};

/// Everything that is in a picture of the map, except the camera. Immutable once shared.
struct SceneContent {
    std::uint64_t order = 0;  ///< number of the SceneOrder for which it was made
    bool complete = true;     ///< false while some scans are not prepared yet
    MapViewSettings settings;
    std::vector<SceneScan> scans;  ///< same order as in Map::scans
    /// Drawn in addition to the map: scans at poses that they may get, new things and things that have
    /// disappeared.
    std::vector<SceneScan> ghosts;
    bool moves = false;                       ///< whether some ghosts are scans at poses that they may get
    bool dragged = false;                     ///< whether these are scans that the operator drags
    bool changes = false;                     ///< whether changes are shown; then everything else is dimmed()
    std::shared_ptr<const VoxelMesh> voxels;  ///< only in the voxel look
    std::vector<SceneRobot> robots;           ///< robots that took the scans, and others of the team
    SceneAges ages = SceneAges::Minutes;
    std::uint64_t inQuestion = 0;    ///< id of the uncertain scan that the operator is asked about; 0: none
    std::optional<ColourRamp> ramp;  ///< set if a number determines the colours
    std::vector<Eigen::Vector3d> places;  ///< what a camera should frame, in the map's frame [m]

    /// Whether ceilings are drawn. They are never drawn while changes are shown, which they would hide.
    [[nodiscard]] bool withCeiling() const { return settings.withCeiling() && !changes; }
};
using SceneContentPtr = std::shared_ptr<const SceneContent>;

}  // namespace leitstand
