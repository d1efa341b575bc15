#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/perception/heat.h"
#include "core/perception/pixel_ray.h"
#include "core/robot/samples/status_samples.h"
#include "robots/control/driving/explorer.h"
#include "robots/control/driving/fuzzy_drive.h"

namespace leitstand {

/// A body's heat, seen from the robot.
struct HeatCue {
    Time at{};
    Ray ray;                    ///< through its middle; in the odometry's frame
    double width = 0.0;         ///< of the blob [rad]
    double temperature = 33.0;  ///< mean [degrees C]
    double confidence = 0.5;    ///< 0 to 1
    double size = 1.0;          ///< square root of the solid angle of what is seen of it [rad]
    bool cut = false;           ///< by the picture's border: there may be more of it
    double clothes = 1.0;       ///< what is lukewarm and hangs together with it [sr]
};
/// The cues of the bodies in a picture, the most convincing first. @p opticalInOdom: of the camera (x right,
/// y down, z forward) when the picture was taken.
[[nodiscard]] std::vector<HeatCue> cuesFrom(const std::vector<HeatBlob>& blobs, const ThermalPicture& picture,
                                            const CameraInfoSample& camera, const Pose& opticalInOdom,
                                            Time at);

struct VictimApproachSettings {
    double distance = 0.80;     ///< from the body's front to the victim's nearest surface [m]
    double tolerance = 0.025;   ///< of it, to stop correcting [m]
    double slowFrom = 0.6;      ///< before the end, it slows down [m]
    double speed = 0.25;        ///< [m/s]
    double turnRate = 0.6;      ///< [rad/s]
    double bandMargin = 0.05;   ///< beside the heat, points still count as the victim's [rad]
    double lostAfter = 4.0;     ///< without a cue it gives up [s]
    double giveUpAfter = 90.0;  ///< altogether [s]
    double settle = 2.6;        ///< stands before it believes a distance: a turn of the scanner [s]
    double sameVictim = 1.0;    ///< reports nearer than that are of one victim [m]
    double lying = 0.55;        ///< what is higher is no part of a victim that lies [m]
    double length = 1.2;        ///< of a victim, from its heat [m]
    double link = 0.25;         ///< between points of one victim [m]
    double highest = 1.0;       ///< heat higher over the ground is of people beyond walls [m]
    double glimpse = 0.03;      ///< of skin: what is smaller from where it stands goes on behind an edge [m]
    double clothes = 0.004;     ///< beside the skin; with less it is a lamp, or a heater [m2]
    int tries = 3;              ///< to see more of a victim of which it had a glimpse
};

/// One step of an approach.
struct ApproachStep {
    DriveVelocity velocity;
    bool done = false;               ///< stands in front of the victim
    bool failed = false;             ///< gave up
    std::string reason;              ///< in words
    std::optional<double> distance;  ///< from the robot's front to the victim, when measured [m]
};

/// Drives up to a source of body heat (paper, section 2.3): turns, approaches, stops with its front 80 cm
/// from the nearest surface, reports, waits. Gives up safely when the cue is lost; also where only a glimpse
/// of it is left, past an edge, until more of it is seen from elsewhere; and where what is warm is bare, as
/// lamps and heaters are. Pure: times are passed in.
class VictimApproach {
public:
    VictimApproach(FuzzyDrive drive, const VictimApproachSettings& settings = {});

    /// Which of @p cues matters: before an approach the first that is new, then that of the same body.
    [[nodiscard]] std::optional<HeatCue> pick(const std::vector<HeatCue>& cues, const VirtualScanView& view,
                                              const Pose& baseInOdom) const;
    /// Whether @p cue is worth an approach: not a victim that has been reported (or given up) already.
    [[nodiscard]] bool isNew(const HeatCue& cue, const VirtualScanView& view, const Pose& baseInOdom) const;
    void start(const HeatCue& cue, Time now);
    void abort();
    /// Where the heat that it drives to is, in base_link; left positive [rad].
    [[nodiscard]] double bearing(const Pose& baseInOdom) const;
    [[nodiscard]] bool isActive() const { return m_phase != Phase::Idle; }

    /// @p cue: the newest, if there is one.
    [[nodiscard]] ApproachStep step(const std::optional<HeatCue>& cue, const VirtualScanView& view,
                                    const Pose& baseInOdom, Time now);
    /// All victims found so far, in odom; the header is left to the caller. Grows when a step is done.
    [[nodiscard]] const std::vector<Sighting>& sightings() const { return m_sightings; }

private:
    enum class Phase : std::uint8_t { Idle, Turn, Approach, Settle, Reached };
    /// The victim's nearest surface point.
    struct Target {
        Eigen::Vector2d inBase = Eigen::Vector2d::Zero();  ///< [m]
        double distance = 0.0;                             ///< from the body's front [m]
        double age = 0.0;                                  ///< of the measurement [s]
        double top = 0.0;                                  ///< height of what stands there [m]
        bool certain = false;                              ///< the heat does not pass by its edge
    };
    void take(const HeatCue& cue);
    /// How high the heat is where it meets the vertical through @p place in odom; over the robot's ground
    /// [m].
    [[nodiscard]] static double heightAt(const HeatCue& cue, const Eigen::Vector2d& place,
                                         const Pose& baseInOdom);
    [[nodiscard]] std::optional<Target> target(const HeatCue& cue, const VirtualScanView& view,
                                               const Pose& baseInOdom) const;
    /// What is low and hangs together with @p heat: the whole victim, not only what is warm of it.
    [[nodiscard]] std::vector<Target> wholeVictim(std::vector<Target> heat,
                                                  const VirtualScanView& view) const;
    [[nodiscard]] bool isKnown(const Eigen::Vector2d& place) const;
    /// How much of the skin is seen, across, when it is at @p place in odom [m].
    [[nodiscard]] static double seenOf(const HeatCue& cue, const Eigen::Vector2d& place);
    /// Likewise of clothes [m2].
    [[nodiscard]] static double clothesOf(const HeatCue& cue, const Eigen::Vector2d& place);
    [[nodiscard]] ApproachStep leave(const std::string& reason);
    [[nodiscard]] ApproachStep giveUp(const std::string& reason, const Eigen::Vector2d& place);
    [[nodiscard]] ApproachStep reach(const Target& target, const Pose& baseInOdom);
    [[nodiscard]] bool isBehindSomething(const std::optional<Target>& target, double bearing,
                                         const VirtualScanView& view) const;
    [[nodiscard]] DriveVelocity towards(const std::optional<Target>& target, double bearing,
                                        const VirtualScanView& view, std::string& reason) const;
    [[nodiscard]] ApproachStep goAround(const Eigen::Vector2d& place, const VirtualScanView& view,
                                        const Pose& baseInOdom, Time now);

    FuzzyDrive m_drive;
    VictimApproachSettings m_settings;
    Explorer m_around;  ///< finds the way when something stands before the heat
    Phase m_phase = Phase::Idle;
    Time m_started{}, m_cueAt{}, m_since{};
    int m_corrections = 0;                   ///< of the distance, so far
    HeatCue m_cue;                           ///< newest
    std::optional<Eigen::Vector2d> m_place;  ///< where it was measured while in sight; odom [m]
    std::optional<Eigen::Vector2d> m_begun;  ///< where it seemed to be at first; odom [m]
    bool m_detour = false;                   ///< on the way around something
    std::vector<Sighting> m_sightings;
    std::vector<Eigen::Vector2d> m_givenUp;  ///< places in odom [m]
    std::vector<Eigen::Vector2d> m_hidden;   ///< likewise, where it had a glimpse, each time
};

}  // namespace leitstand
