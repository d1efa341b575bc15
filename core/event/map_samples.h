#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/scan.h"
#include "core/event/sample_header.h"
#include "core/event/scan_pose.h"

namespace leitstand {

/// A scan that entered the map, labelled and reduced, with its first pose.
struct KeyScanSample {
    Time stamp{};                          ///< when the scan entered the map, station's clock
    std::uint64_t id = 0;                  ///< id of the scan within the mission, from 1
    ScanPtr scan;                          ///< never null
    Pose sensorInBase = Pose::Identity();  ///< pose at the end of the sweep
    Pose scanInMap = Pose::Identity();  ///< pose when the scan entered the map; ScanPosesSample corrects it
    std::uint64_t matched = 0;          ///< id of the scan that it was registered against; 0: none
};

/// Poses that a registration or a correction changed, all together. Also the operator's decisions about them.
struct ScanPosesSample {
    enum class Cause : std::uint8_t { Registration, LoopClosure, Operator };
    Time stamp{};  ///< station's clock
    std::string station;
    Cause cause = Cause::Registration;
    std::vector<ScanPose> poses;
};

/// The area that belongs to the map from now on, as the operator decided.
struct MapCropSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::vector<Eigen::Vector2d> polygon;  ///< corners in the map [m]; empty: everything belongs to it
    /// Points above this height are left out, in the map [m].
    double ceiling = std::numeric_limits<double>::infinity();
};

/// Pose of a robot in the map that another robot's scans made, and how well its own laser confirms the pose.
struct RobotPlaceSample {
    enum class Cause : std::uint8_t {
        Slot,        ///< searched for and found beside the robot that makes the map
        Operator,    ///< placed by the operator
        Tracked,     ///< tracked since it was placed
        FoundAgain,  ///< lost, searched for, and found away from where odometry put it
        Seen,        ///< searched for and found at a place where another robot sees something of its size
    };
    Time stamp{};  ///< station's clock
    std::string station;
    std::string robot;
    Cause cause = Cause::Tracked;
    Time measured{};                    ///< time of the measurement, robot's clock
    Pose baseInMap = Pose::Identity();  ///< base_link at @ref measured
    /// Pose of odometry's frame from @ref measured on, levelled by the gyros.
    Pose odomInMap = Pose::Identity();
    double certainty = 0.0;  ///< certainty of the pose, 0 to 1
    double overlap = 0.0;    ///< share of what the robot sees that fits the map
    bool certain = false;    ///< false: from here on, only odometry moves the robot
    std::string how;         ///< why it is certain or not, as a code (placement_format.h)
};

/// A grid map or costmap of a robot's own navigation (nav_msgs/msg/OccupancyGrid).
struct OccupancyGridSample {
    static constexpr std::size_t MostCells = 16'000'000;  ///< of 5 cm: 200 m x 200 m
    static constexpr std::int8_t UnknownCell = -1, Occupied = 100;

    SampleHeader header;      ///< its frame is often "map", which the robot's localisation moves
    Time loaded{};            ///< when the robot loaded it from a file; epoch: it did not
    double resolution = 0.0;  ///< edge of a cell [m]; above 0 where there are cells
    int width = 0;            ///< number of cells along x
    int height = 0;           ///< number of cells along y
    /// Pose of the grid in the header's frame: the outer corner of cell (0, 0), x and y along its edges.
    Pose gridInFrame = Pose::Identity();
    /// Cell (x, y) is at y * width + x. From 0, free, to Occupied; UnknownCell and everything else: unknown.
    std::vector<std::int8_t> cells;
};

/// A rectangle of cells that changed in a grid (map_msgs/msg/OccupancyGridUpdate). Its topic is that of the
/// grid, with "_updates" behind.
struct GridUpdateSample {
    SampleHeader header;
    int x = 0;                       ///< its first column in the grid
    int y = 0;                       ///< its first row in the grid
    int width = 0;                   ///< number of cells along x
    int height = 0;                  ///< number of cells along y
    std::vector<std::int8_t> cells;  ///< as OccupancyGridSample::cells
};

/// What a marker looks like (visualization_msgs/msg/Marker; meshes are boxes here).
enum class MarkerShape : std::uint8_t {
    Arrow,      ///< from points[0] to points[1]; without points along x, size.x() long
    Box,        ///< as large as `size`; with points, one at each
    Ellipsoid,  ///< the same
    Cylinder,   ///< the same, upright
    LineStrip,  ///< from point to point
    LineList,   ///< between points[0] and [1], [2] and [3], ...
    Points,
    Text,
    Triangles,  ///< of points[0] to [2], [3] to [5], ...
};

/// Red, green, blue and opacity, each 0 to 1.
struct MarkerColour {
    float r = 1.0F, g = 1.0F, b = 1.0F, a = 1.0F;
    friend bool operator==(const MarkerColour&, const MarkerColour&) = default;
};

/// Something that a robot draws.
struct Marker {
    SampleHeader header;
    std::string space;  ///< space and id name it on its topic
    std::int32_t id = 0;
    bool removed = false;  ///< the marker of that name is drawn no longer; everything below does not count
    MarkerShape shape = MarkerShape::Box;
    Pose markerInFrame = Pose::Identity();
    Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< [m]
    MarkerColour colour;
    /// Whether it moves along with its frame; otherwise it stays where that was when it was sent.
    bool frameLocked = false;
    std::chrono::nanoseconds lifetime{};  ///< it is drawn no longer after this time; 0: until it is removed
    std::vector<Eigen::Vector3d> points;  ///< in the marker's own frame [m]
    std::string text;
};

/// Markers of visualization_msgs (Marker, MarkerArray), and what is drawn like them: outlines
/// (geometry_msgs/msg/PolygonStamped), poses with their uncertainty (PoseWithCovarianceStamped), and boxes of
/// detections (vision_msgs/msg/Detection3DArray).
struct MarkersSample {
    static constexpr std::size_t MostMarkers = 5'000, MostPoints = 100'000;  ///< of a message

    bool replacesAll = false;  ///< whether everything that was drawn on the topic before is gone
    std::vector<Marker> markers;
};

}  // namespace leitstand
