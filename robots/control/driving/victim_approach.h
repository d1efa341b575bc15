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
    double tolerance = 0.025;   ///< of it, to stop correcting [m]
    double slowFrom = 0.6;      ///< before the end, it slows down [m]
    double speed = 0.25;        ///< [m/s]
    double turnRate = 0.6;      ///< [rad/s]
    double lostAfter = 4.0;     ///< without a cue it gives up [s]
    double giveUpAfter = 90.0;  ///< altogether [s]
    double stuckAfter = 6.0;    ///< without a move, near a victim in sight: it comes to no better place [s]
    double stuckWithin = 1.3;   ///< ... from its front to the victim [m]
    double settle = 2.6;        ///< stands before it believes a distance: a turn of the scanner [s]
    double sameVictim = 1.0;    ///< reports nearer than that are of one victim [m]
    double sameLamp = 0.6;      ///< likewise of what is no person: a victim may lie beside it [m]
    double highest = 1.0;       ///< heat higher over the ground is of people beyond walls [m]
    double glimpse = 0.03;      ///< of skin: what is smaller from where it stands goes on behind an edge [m]
    double clothes = 0.004;     ///< beside the skin; with less it is a lamp, or a heater [m2] ...
    double bare = 0.20;         ///< ... also where it goes on beyond the picture, when so large: no face [m]
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
    /// Where the heat of @p cue is, in odom [m], when that is near, of another body than it drives to, and
    /// worth an approach, too.
    [[nodiscard]] std::optional<Eigen::Vector3d> another(const HeatCue& cue, const VirtualScanView& view,
                                                         const Pose& baseInOdom) const;
    void start(const HeatCue& cue, Time now);
    void abort();
    /// Where the heat that it drives to is, in odom [m]: what the camera has to look at. The surface that it
    /// stops before may be elsewhere, as the feet of a victim whose head is warm.
    [[nodiscard]] const Eigen::Vector3d& heat() const { return m_heat; }
    [[nodiscard]] bool isActive() const { return m_phase != Phase::Idle; }

    /// @p cue: the newest, if there is one.
    [[nodiscard]] ApproachStep step(const std::optional<HeatCue>& cue, const VirtualScanView& view,
                                    const Pose& baseInOdom, Time now);
    /// All victims found so far, in odom; the header is left to the caller. Grows when a step is done.
    [[nodiscard]] const std::vector<Sighting>& sightings() const { return m_sightings; }

private:
    enum class Phase : std::uint8_t { Idle, Turn, Approach, Settle, Reached };
    /// Where heat was that it left; the same heat, seen from afar, may seem to be where it seemed to be then.
    struct Left {
        Eigen::Vector2d place, begun;  ///< in odom [m]
        double radius = 0.0;           ///< around both [m]
        [[nodiscard]] bool isAt(const Eigen::Vector2d& where) const;
    };
    /// The most that cues show of one heat.
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
    /// What heat is, after all that was @p seen of it, when that is @p away from the camera [m].
    [[nodiscard]] bool isHidden(const Seen& seen, double away) const;
    [[nodiscard]] bool isBare(const Seen& seen, double away) const;
    /// Whether it has stood for too long to come to a better place than this.
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
    Eigen::Isometry2d m_moved = Eigen::Isometry2d::Identity();  ///< where it was then; odom
    bool m_stuck = false;   ///< what it measures next is as near as it comes
    int m_corrections = 0;  ///< of the distance, so far
    HeatCue m_cue;          ///< newest
    Eigen::Vector3d m_heat = Eigen::Vector3d::Zero();
    std::optional<Eigen::Vector2d> m_place;  ///< where it was measured while in sight; odom [m]
    std::optional<Eigen::Vector2d> m_begun;  ///< where it seemed to be at first; odom [m]
    bool m_detour = false;                   ///< on the way around something
    std::vector<Sighting> m_sightings;
    Seen m_seen;  ///< of it while it stands before it
    std::vector<Left> m_givenUp;
    std::vector<Left> m_hidden;  ///< where it had a glimpse, each time
};

}  // namespace leitstand
