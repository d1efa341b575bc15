#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/services/places/sensor_places.h"
#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/event/status_samples.h"
#include "core/mapping/seen_points.h"
#include "core/mission/finds/placed_cue.h"
#include "core/perception/cues/codes.h"
#include "core/perception/cues/gas_rise.h"
#include "core/perception/cues/motion.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct GasSample;
struct PictureSample;
struct SightingSample;

/// How thoroughly a robot's samples are searched.
struct CueSettings {
    std::chrono::milliseconds motionEvery{
        180};  ///< time between pictures of a camera that are compared for motion
    /// Time between pictures that are searched for codes and placards.
    std::chrono::milliseconds signsEvery{450};
    std::chrono::milliseconds longestWait{500};  ///< longest time that a picture waits for odometry
    double fastest = 0.9;   ///< pictures of a camera that turns faster than this are ignored [rad/s]
    double standing = 0.7;  ///< a camera must stand for this time before motion is used [s]
    /// People above this height over the robot's base are beyond walls, and ignored [m].
    double highest = 1.0;
    double lowest = -0.6;       ///< everything below this height over the robot's base is ignored [m]
    double farthestHeat = 6.0;  ///< body heat farther away than this is ignored [m]
    double farthest = 5.0;      ///< motion, codes and placards farther away than this are ignored [m]
};

/// A thing in a picture whose place is requested.
struct LookedAt {
    Event picture;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< position in the picture [px]
    int width = 0, height = 0;                        ///< size of the picture [px]
    double halfAngle = 0.0;                           ///< half the angle that it spans in the camera [rad]
};

/// Finds cues in what a robot sends and places them in the map. The caller reports where the robot is. It has
/// no thread; one call at a time.
class CueFinder {
public:
    explicit CueFinder(const RobotDescription& robot, const CueSettings& settings = {});
    CueFinder(const CueFinder&) = delete;
    CueFinder& operator=(const CueFinder&) = delete;

    /// Takes odometry, inertial unit, transforms, scans, pictures, camera infos, gas and sightings of this
    /// robot; ignores other events.
    void onEvent(const Event& event);
    /// Sets where the robot was. Before the first call, nothing can be placed.
    void correct(const MapFix& fix) { m_places.correct(fix); }
    /// Returns the cues found since the last call. Their key scan is not set yet.
    [[nodiscard]] std::vector<PlacedCue> found();
    [[nodiscard]] const RobotInMap& now() const { return m_places.now(); }
    /// Returns the place of @p looked in the map. Empty when the picture is too old or nothing was scanned
    /// there.
    [[nodiscard]] std::optional<PlacedCue> locate(const LookedAt& looked);
    /// Whether @p picture, from a calibrated camera, shows @p inMap [m]: it is within the picture, and no
    /// scanned point hides it.
    [[nodiscard]] bool shows(const Event& picture, const Eigen::Vector3d& inMap);

private:
    /// Where a camera was when it took a picture.
    struct View {
        Pose opticalInOdom, opticalInMap, baseInMap;
        bool certain = false;
        double turning = 0.0;  ///< how fast it turns [rad/s]
    };
    struct Camera {
        std::optional<CameraInfoSample> info;
        PictureDecoder decoder;
        MotionFinder motion;
        Time compared{}, read{};  ///< times of the pictures that were last searched for motion, and for signs
        Time stoodSince{};
        std::optional<Pose> before;  ///< pose in the base at the last picture
        Time beforeAt{};
    };
    void look(Time now);
    void look(const Event& event);
    void lookForHeat(const Event& event, Camera& camera, const View& view);
    void lookForMotion(const Event& event, Camera& camera, const View& view, const Picture& picture);
    void lookForSigns(const Event& event, const Camera& camera, const View& view, const Picture& picture);
    void smell(const Event& event, const GasSample& gas);
    void receive(const Event& event, const SightingSample& sightings);
    [[nodiscard]] std::optional<View> viewOf(const Event& event, const PictureSample& picture,
                                             Camera& camera);
    [[nodiscard]] Cue cueOf(const Event& event, const char* kind, Time stamp) const;
    /// Keeps @p cue, placed where @p pixel of the picture shows. Returns false when nothing was scanned
    /// there.
    bool place(PlacedCue cue, const Camera& camera, const View& view, const Eigen::Vector2d& pixel, int width,
               int height, double halfAngle, double farthest);
    [[nodiscard]] std::optional<RayHit> meet(const View& view, const Eigen::Vector3d& direction,
                                             double halfAngle, double farthest,
                                             const SeenPoints::Shows& shows = {}) const;
    void keep(PlacedCue cue, const View& view);

    const RobotDescription m_robot;
    const CueSettings m_settings;
    SensorPlaces m_places;
    SeenPoints m_seen;
    CodeReader m_codes;
    std::map<std::string, Camera> m_cameras;  ///< by sensor
    std::map<std::string, GasWatch> m_gases;  ///< by sensor
    std::map<std::uint32_t, Sighting> m_sightings;
    std::optional<Event> m_notReceived;  ///< sightings of a robot that has no place yet
    std::deque<Event> m_waiting;         ///< pictures that wait for odometry
    /// Waiting scans, with the pose of their sensor in the base.
    std::deque<std::pair<Event, Pose>> m_slices;
    Time m_movedAt{};  ///< time of the last motion, robot's clock
    std::vector<PlacedCue> m_found;
};

}  // namespace leitstand
