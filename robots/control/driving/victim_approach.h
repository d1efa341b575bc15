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
    /// Distance from the body's front to the victim's nearest surface at the end [m].
    double distance = 0.80;
    double tolerance = 0.025;   ///< it stops correcting when the distance is this accurate [m]
    double slowFrom = 0.6;      ///< it slows down from this distance before the end [m]
    double speed = 0.25;        ///< [m/s]
    double turnRate = 0.6;      ///< [rad/s]
    double lostAfter = 4.0;     ///< it gives up after this time without a cue [s]
    double giveUpAfter = 90.0;  ///< it gives up after this total time [s]
    /// If it has not moved for this time near a visible victim, there is no better place [s].
    double stuckAfter = 6.0;
    double stuckWithin = 1.3;  ///< largest distance from its front to the victim for that rule [m]
    double settle = 2.6;  ///< it stands for this long before it uses a distance: a turn of the scanner [s]
    double sameVictim = 1.0;  ///< reports at most this far apart are of the same victim [m]
    /// Cues at most this far from a lamp are of that lamp; a victim may lie beside it [m].
    double sameLamp = 0.6;
    double highest = 1.0;    ///< heat above this height over the ground belongs to people beyond walls [m]
    double glimpse = 0.03;   ///< if the visible skin is smaller, it is only a glimpse past an edge [m]
    double clothes = 0.004;  ///< least lukewarm area beside the skin; otherwise it is a lamp or a heater [m2]
    double bare = 0.20;  ///< if skin is at least this large, it is no face, even when the picture cuts it [m]
    int tries = 3;       ///< number of tries to see more of a victim after a glimpse
};

/// One step of an approach.
struct ApproachStep {
    DriveVelocity velocity;
    bool done = false;               ///< it stands in front of the victim
    bool failed = false;             ///< it gave up
    std::string reason;              ///< English text
    std::optional<double> distance;  ///< from the robot's front to the victim; empty: not measured [m]
};

/// Drives up to a source of body heat (paper, section 2.3): turns, approaches, stops with its front 80 cm
/// from the nearest surface, reports, waits. Gives up safely when the cue is lost. If only a glimpse of the
/// heat is visible past an edge, leaves it until more is seen from elsewhere. Also gives up heat without
/// clothes, as of lamps and heaters. Pure: times are passed in.
class VictimApproach {
public:
    VictimApproach(FuzzyDrive drive, const VictimApproachSettings& settings = {});

    /// Returns the cue to follow. Before an approach, it is the first new one; during an approach, that of
    /// the same body. Empty: there is none.
    [[nodiscard]] std::optional<HeatCue> pick(const std::vector<HeatCue>& cues, const VirtualScanView& view,
                                              const Pose& baseInOdom) const;
    /// Returns whether @p cue is worth an approach: it is no victim that was already reported or given up.
    [[nodiscard]] bool isNew(const HeatCue& cue, const VirtualScanView& view, const Pose& baseInOdom) const;
    /// Returns the place of the heat of @p cue in odom [m], if it is near, belongs to another body than the
    /// target, and is worth an approach. Otherwise empty.
    [[nodiscard]] std::optional<Eigen::Vector3d> another(const HeatCue& cue, const VirtualScanView& view,
                                                         const Pose& baseInOdom) const;
    void start(const HeatCue& cue, Time now);
    void abort();
    /// Returns the place of the heat to which it drives, in odom [m]; the camera has to look there. The robot
    /// may stop in front of another part of the victim, such as the feet if the head is warm.
    [[nodiscard]] const Eigen::Vector3d& heat() const { return m_heat; }
    [[nodiscard]] bool isActive() const { return m_phase != Phase::Idle; }

    /// @p cue: the newest cue, if there is one.
    [[nodiscard]] ApproachStep step(const std::optional<HeatCue>& cue, const VirtualScanView& view,
                                    const Pose& baseInOdom, Time now);
    /// Returns all victims so far, in odom; the caller sets the header. It has one more after a step with
    /// `done`.
    [[nodiscard]] const std::vector<Sighting>& sightings() const { return m_sightings; }

private:
    enum class Phase : std::uint8_t { Idle, Turn, Approach, Settle, Reached };
    /// Heat that the robot left. It has its last place, and the place where it seemed to be when it was first
    /// seen (`begun`): from afar it may seem to be there again.
    struct Left {
        Eigen::Vector2d place, begun;  ///< both places in odom [m]
        double radius = 0.0;           ///< radius around both places [m]
        [[nodiscard]] bool isAt(const Eigen::Vector2d& where) const;
    };
    /// Largest sizes of one heat in all its cues.
    struct Seen {
        double skin = 0.0;     ///< width of the skin [rad]
        double clothes = 0.0;  ///< lukewarm area [sr]
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
    /// Return whether the heat is only a glimpse past an edge, or without clothes like a lamp, given
    /// everything @p seen of it. @p away: distance from the camera [m].
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
    Explorer m_around;  ///< finds the way if something stands in front of the heat
    Phase m_phase = Phase::Idle;
    Time m_started{}, m_cueAt{}, m_since{}, m_movedAt{};
    Eigen::Isometry2d m_moved = Eigen::Isometry2d::Identity();  ///< pose at m_movedAt, in odom
    bool m_stuck = false;   ///< it does not get nearer: its next measurement is used
    int m_corrections = 0;  ///< number of corrections of the distance so far
    HeatCue m_cue;          ///< newest cue
    Eigen::Vector3d m_heat = Eigen::Vector3d::Zero();
    /// Where the target was measured while it was visible, in odom [m].
    std::optional<Eigen::Vector2d> m_place;
    std::optional<Eigen::Vector2d> m_begun;  ///< where the target first seemed to be, in odom [m]
    bool m_detour = false;                   ///< whether it is driving around something
    std::vector<Sighting> m_sightings;
    Seen m_seen;  ///< all cues of the target while the robot stands in front of it
    std::vector<Left> m_givenUp;
    std::vector<Left> m_hidden;  ///< one for each glimpse
};

}  // namespace leitstand
