#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/status_samples.h"
#include "robots/control/driving/explorer.h"
#include "robots/control/driving/fuzzy_drive.h"
#include "robots/control/driving/heat_target.h"

namespace leitstand {

struct VictimApproachSettings {
    double distance = 0.80;     ///< from the body's front to the victim's nearest surface [m]
    double tolerance = 0.025;   ///< of the distance, to stop correcting [m]
    double slowFrom = 0.6;      ///< slows down from this distance before the end [m]
    double speed = 0.25;        ///< [m/s]
    double turnRate = 0.6;      ///< [rad/s]
    double lostAfter = 4.0;     ///< gives up after so long without a cue [s]
    double giveUpAfter = 90.0;  ///< gives up after so long altogether [s]
    double stuckAfter = 6.0;    ///< time without motion near a visible victim: there is no better place [s]
    double stuckWithin = 1.3;   ///< what counts as near there: from the robot's front to the victim [m]
    double settle = 2.6;        ///< stands so long before it trusts a distance: a turn of the scanner [s]
    double sameVictim = 1.0;    ///< reports nearer to each other are of one victim [m]
    double sameLamp = 0.6;      ///< cues nearer to a lamp are of that lamp; a victim may lie beside it [m]
    double highest = 1.0;       ///< heat higher over the ground belongs to people beyond walls [m]
    double glimpse = 0.03;      ///< visible skin that is smaller is a glimpse past an edge [m]
    double clothes = 0.004;     ///< lukewarm area beside the skin; with less it is a lamp or a heater [m2]
    double bare = 0.20;         ///< skin this large is no face, even when the picture cuts it [m]
    int tries = 3;              ///< to see more of a victim after a glimpse
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
/// from the nearest surface, reports, waits. Gives up safely when the cue is lost. Leaves heat when only a
/// glimpse of it is visible past an edge, until more of it is seen from elsewhere. Also gives up heat that is
/// bare, as lamps and heaters are. Pure: times are passed in.
class VictimApproach {
public:
    VictimApproach(FuzzyDrive drive, const VictimApproachSettings& settings = {});

    /// Returns the cue to follow: before an approach, the first that is new; during one, that of the same
    /// body. Empty: there is none.
    [[nodiscard]] std::optional<HeatCue> pick(const std::vector<HeatCue>& cues, const VirtualScanView& view,
                                              const Pose& baseInOdom) const;
    /// Returns whether @p cue is worth an approach: not a victim that was already reported (or given up).
    [[nodiscard]] bool isNew(const HeatCue& cue, const VirtualScanView& view, const Pose& baseInOdom) const;
    /// Returns the place of the heat of @p cue in odom [m] when it is near, belongs to another body than the
    /// target, and is worth an approach, too.
    [[nodiscard]] std::optional<Eigen::Vector3d> another(const HeatCue& cue, const VirtualScanView& view,
                                                         const Pose& baseInOdom) const;
    void start(const HeatCue& cue, Time now);
    void abort();
    /// Returns the place of the heat that it drives to, in odom [m]; the camera has to look there. The robot
    /// may stop before another part of the victim, such as the feet of one whose head is warm.
    [[nodiscard]] const Eigen::Vector3d& heat() const { return m_heat; }
    [[nodiscard]] bool isActive() const { return m_phase != Phase::Idle; }

    /// @p cue: the newest, if there is one.
    [[nodiscard]] ApproachStep step(const std::optional<HeatCue>& cue, const VirtualScanView& view,
                                    const Pose& baseInOdom, Time now);
    /// Returns all victims so far, in odom; the header is left to the caller. Grows when a step is done.
    [[nodiscard]] const std::vector<Sighting>& sightings() const { return m_sightings; }

private:
    enum class Phase : std::uint8_t { Idle, Turn, Approach, Settle, Reached };
    /// Heat that the robot left: its place, and `begun`, where it seemed to be when it was first seen. From
    /// afar the same heat may seem to be there again.
    struct Left {
        Eigen::Vector2d place, begun;  ///< in odom [m]
        double radius = 0.0;           ///< around both [m]
        [[nodiscard]] bool isAt(const Eigen::Vector2d& where) const;
    };
    /// The largest extents of one heat in all its cues.
    struct Seen {
        double skin = 0.0;     ///< across [rad]
        double clothes = 0.0;  ///< [sr]
        bool skinCut = false, clothesCut = false;
        void add(const HeatCue& cue);
    };
    void take(const HeatCue& cue);
    [[nodiscard]] Left leftAt(const Eigen::Vector2d& place, double radius) const;
    [[nodiscard]] bool isKnown(const Eigen::Vector2d& place) const;
    [[nodiscard]] std::optional<HeatTarget> target(const HeatCue& cue, const VirtualScanView& view,
                                                   const Pose& baseInOdom) const;
    [[nodiscard]] ApproachStep leave(const std::string& reason);
    [[nodiscard]] ApproachStep giveUp(const std::string& reason, const Eigen::Vector2d& place, double radius);
    /// Return whether the heat is only a glimpse past an edge, or bare as a lamp is, by all that was @p seen
    /// of it. @p away: distance from the camera [m].
    [[nodiscard]] bool isHidden(const Seen& seen, double away) const;
    [[nodiscard]] bool isBare(const Seen& seen, double away) const;
    /// Returns whether the robot has not moved for longer than VictimApproachSettings::stuckAfter.
    [[nodiscard]] bool isStuck(const Pose& baseInOdom, Time now);
    [[nodiscard]] ApproachStep settled(const HeatTarget& target, const Pose& baseInOdom);
    [[nodiscard]] ApproachStep reach(const HeatTarget& target, const Pose& baseInOdom);
    [[nodiscard]] bool isBehindSomething(const std::optional<HeatTarget>& target, double bearing,
                                         const VirtualScanView& view) const;
    [[nodiscard]] DriveVelocity towards(const std::optional<HeatTarget>& target, double bearing,
                                        const VirtualScanView& view, std::string& reason) const;
    [[nodiscard]] ApproachStep goAround(const Eigen::Vector2d& place, const VirtualScanView& view,
                                        const Pose& baseInOdom, Time now);

    FuzzyDrive m_drive;
    VictimApproachSettings m_settings;
    Explorer m_around;  ///< finds the way when something stands before the heat
    Phase m_phase = Phase::Idle;
    Time m_started{}, m_cueAt{}, m_since{}, m_movedAt{};
    Eigen::Isometry2d m_moved = Eigen::Isometry2d::Identity();  ///< pose at m_movedAt; odom
    bool m_stuck = false;   ///< it comes no nearer: its next measurement counts
    int m_corrections = 0;  ///< of the distance, so far
    HeatCue m_cue;          ///< newest
    Eigen::Vector3d m_heat = Eigen::Vector3d::Zero();
    std::optional<Eigen::Vector2d> m_place;  ///< where the target was measured while in sight; odom [m]
    std::optional<Eigen::Vector2d> m_begun;  ///< where the target seemed to be at first; odom [m]
    bool m_detour = false;                   ///< on the way around something
    std::vector<Sighting> m_sightings;
    Seen m_seen;  ///< of the target, while the robot stands before it
    std::vector<Left> m_givenUp;
    std::vector<Left> m_hidden;  ///< one for each glimpse
};

}  // namespace leitstand
