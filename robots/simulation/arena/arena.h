#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "robots/simulation/arena/material.h"

namespace leitstand::simulation {

/// How hard an arena is (paper, section 1.1), or that it is a building.
enum class Grade : std::uint8_t { Yellow, Orange, Red, Building };
inline constexpr int GradeCount = 4;
[[nodiscard]] std::string toString(Grade grade);

/// Where a victim lies (paper, section 1.1).
enum class Situation : std::uint8_t {
    Surface,   ///< it lies in the open
    Trapped,   ///< boards lie on it
    Void,      ///< it is in a box that is open on one side
    Entombed,  ///< it is in a box that has only a hole
};
inline constexpr int SituationCount = 4;
[[nodiscard]] std::string toString(Situation situation);

/// Kind of an arena's element. An element's frame has its origin in the middle of its base, z up, x along its
/// length.
enum class ElementKind : std::uint8_t {
    Floor,       ///< a slab whose top is in the plane of the frame: size x, y, thickness
    Wall,        ///< a box
    Door,        ///< a wall with an opening of `width`; its leaf is open by `angle`
    Ramp,        ///< a wedge that rises along x from 0 to size z
    Stairs,      ///< steps of `riser` along x, up to size z
    StepField,   ///< square columns on a grid of `cell`, as high as `heights`
    Ceiling,     ///< a slab above the plane of the frame
    Lamp,        ///< a warm, bright sphere; a tube if it is longer than twice its height
    Heater,      ///< a radiator
    Table,       ///< a top with protruding edges, on legs
    Chair,       ///< seat, back, legs
    Overhang,    ///< a board that sticks out of a wall, with nothing below
    Curtain,     ///< cloth that hangs down
    LoosePaper,  ///< crumpled newspaper on the floor
    Foil,        ///< a sheet of plastic, upright in the frame's xz plane
    Rubble,      ///< tilted bricks and boards, placed by `seed`
    Victim,      ///< a manikin on its back, head at +x; robots can reach it from -y; see `victim`
    Sign,  ///< a plate in the frame's xz plane that faces -y: hazard sign or QR code, according to `text`
    Spectator,  ///< a person who walks up and down along x, `width` to each side
    Smoke,      ///< a box of smoke, in which lasers see as far as `reach`
};
inline constexpr int ElementKindCount = 20;
[[nodiscard]] std::string toString(ElementKind kind);

/// Signs of life of a victim, and how it is hidden.
struct VictimTraits {
    std::string tag;  ///< text of the QR code on it, "V-07"
    Situation situation = Situation::Surface;
    bool waving = false;
    double temperature = 33.0;  ///< temperature of the skin [degrees C]; 20: dead
    double co2 = 4000.0;        ///< CO2 of its breath at the mouth [ppm]; 0: none
    bool hidden = false;        ///< whether it cannot be seen from where robots can go
};

/// One thing in an arena.
struct Element {
    ElementKind kind = ElementKind::Wall;
    std::string name;                                    ///< unique, "wall 12"
    Pose pose = Pose::Identity();                        ///< pose of the element's frame in the arena
    Eigen::Vector3d size = Eigen::Vector3d(1, 0.05, 1);  ///< along x, y, z [m]
    Material material = Material::Plywood;
    double temperature = 20.0;           ///< [degrees C]
    double width = 0.0;                  ///< width of a Door's opening; half length of a Spectator's walk [m]
    double angle = 0.0;                  ///< angle of a Door's leaf [rad]
    double riser = 0.0;                  ///< height of a step of Stairs [m]
    double cell = 0.0;                   ///< edge of a cell of a StepField [m]
    std::vector<double> heights;         ///< heights of a StepField, row after row from -y, each along x [m]
    std::string text;                    ///< text of a Sign: "qr:TEXT", "hazard:flammable" ...
    double reach = 0.0;                  ///< how far a laser sees in Smoke [m]
    std::uint64_t seed = 0;              ///< seed of random details: pieces, folds, colours
    std::optional<VictimTraits> victim;  ///< traits of a Victim
};

/// Returns an element of @p kind with its default size, material and traits. Arena files only have what
/// differs from these.
[[nodiscard]] Element elementOf(ElementKind kind);
/// Returns whether elements of @p kind have a temperature of their own, not that of the arena.
[[nodiscard]] bool warmByItself(ElementKind kind);
/// Returns where a victim breathes out, in the arena's frame [m].
[[nodiscard]] Eigen::Vector3d mouthOf(const Element& victim);

/// A place that robots explore. Frame: x east, y north, z up, floor at z = 0 [m].
struct Arena {
    std::string name;  ///< "yellow 7"
    Grade grade = Grade::Yellow;
    std::uint64_t seed = 0;
    /// Corners of its ground [m].
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
    double ambient = 20.0;  ///< temperature of everything without a temperature of its own [degrees C]
    double light = 1.0;     ///< 0: dark except for lamps; 1: bright
    std::vector<Element> elements;
    std::map<std::string, Pose> starts;  ///< base_link of each robot at the start
};

}  // namespace leitstand::simulation
