#pragma once

#include <array>
#include <vector>

#include "robots/simulation/arena/building_generator.h"
#include "robots/simulation/arena/random.h"

namespace leitstand::simulation::building {

inline constexpr double StoreyHeight = 2.6;  ///< from floor to floor [m]
inline constexpr double Slab = 0.2;          ///< thickness of an upper floor [m]
inline constexpr double Clear = StoreyHeight - Slab;
inline constexpr double Corridor = 2.4;    ///< width [m]
inline constexpr double Thickness = 0.12;  ///< of walls [m]
inline constexpr double Landing = 2.0;     ///< at each end of a ramp [m]
inline constexpr double RampRun = 13.0;    ///< level length of a ramp: 11.3 degrees [m]
inline constexpr double ShaftLength = 2 * Landing + RampRun;

/// A frame on a floor, turned by quarters: y away from the corridor, into what lies behind its wall.
struct Spot {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    int quarter = 0;    ///< turned to the left by 90 degrees so often
    double base = 0.0;  ///< height of the floor [m]

    [[nodiscard]] Eigen::Vector2d inArena(double x, double y) const;
    [[nodiscard]] Spot moved(double x, double y) const { return {inArena(x, y), quarter, base}; }
};

/// What lies side by side behind a corridor's wall; its frame's origin is the middle of that wall.
struct Strip {
    Spot frame;
    double length = 0.0, depth = 0.0;
};

/// A building in the making.
class Plan {
public:
    Plan(const BuildingSettings& settings, std::uint64_t seed);

    BuildingSettings settings;
    Random random;
    Arena arena;
    BuildingWays ways;
    double roomDepth = 4.0;        ///< of the rooms around the ring [m]
    double roomLength = 5.4;       ///< about [m]
    std::vector<double> shaftsAt;  ///< where each storey's ramp begins along its strip [m]

    [[nodiscard]] static double rounded(double value);
    /// @p dice: of the plan, or of one room.
    [[nodiscard]] static double length(Random& dice, double least, double most);

    /// Adds @p element with a name of its own at x, y of @p spot, @p up above its floor.
    Element& add(Element element, const Spot& spot, double x, double y, double up = 0.0, double turn = 0.0);
    /// A wall from @p first to @p last along x of @p spot; none where that is nothing.
    void wall(const Spot& spot, double first, double last, double y = 0.0, double height = Clear,
              Material material = Material::Plaster);
    /// A wall along y of @p spot.
    void partition(const Spot& spot, double x, double first, double last, double height = Clear);

    /// Dice of the next room: the same ones for all rooms of twins.
    [[nodiscard]] Random roomDice();
    [[nodiscard]] bool troubled() const { return settings.troubles && !settings.smooth; }

    /// The four strips around the ring of a storey: south, west, north, east.
    [[nodiscard]] std::array<Strip, 4> outerStrips(int storey) const;
    /// Where the ramp from @p storey up lies: every other one in the north, the others in the south.
    [[nodiscard]] Strip shaftStrip(int storey) const { return outerStrips(storey)[storey % 2 == 0 ? 2 : 0]; }

private:
    std::uint64_t m_roomSeed;
    std::array<int, ElementKindCount> m_count{};
};

// Steps of making a building.
void layFloors(Plan& plan);                     ///< slabs with holes above ramps, outer walls, ceiling
void buildShaft(Plan& plan, int storey);        ///< ramp and stairs from @p storey to the next
void buildOuterStrips(Plan& plan, int storey);  ///< rooms around the ring, or bare walls
void buildBlocks(Plan& plan, int storey);       ///< what the ring encloses, left and right of the cross
void furnishCorridors(Plan& plan, int storey);  ///< lamps, signs
void makeTrouble(Plan& plan, int storey);       ///< smoke, and people who walk
void layVictims(Plan& plan);

/// A room behind the wall at y = 0 of @p frame, which it gets, with a door.
struct Room {
    Spot frame;
    double length = 0.0, depth = 0.0;
    bool hall = false;  ///< with pillars
};
void buildRoom(Plan& plan, const Room& room);
/// Its wall towards the corridor alone; returns where the door is, along it [m].
double buildFront(Plan& plan, const Room& room);
/// Rooms side by side from @p first to @p last along a strip, or the bare wall where there is room for none.
void buildRow(Plan& plan, const Strip& strip, double first, double last);

}  // namespace leitstand::simulation::building
