#pragma once

#include <array>
#include <vector>

#include "robots/simulation/arena/building_generator.h"
#include "robots/simulation/arena/random.h"

namespace leitstand::simulation::building {

inline constexpr double StoreyHeight = 2.6;  ///< height from one floor to the next [m]
inline constexpr double Slab = 0.2;          ///< thickness of an upper floor [m]
inline constexpr double Clear = StoreyHeight - Slab;
inline constexpr double Corridor = 2.4;    ///< width of a corridor [m]
inline constexpr double Thickness = 0.12;  ///< thickness of a wall [m]
inline constexpr double Landing = 2.0;     ///< length of the flat part at each end of a ramp [m]
inline constexpr double RampRun = 13.0;    ///< horizontal length of a ramp; it rises by 11.3 degrees [m]
inline constexpr double ShaftLength = 2 * Landing + RampRun;

/// A frame on a floor, turned by quarter turns. Its y axis points away from the corridor, into the area
/// behind the wall.
struct Spot {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    int quarter = 0;    ///< number of left turns by 90 degrees
    double base = 0.0;  ///< height of the floor [m]

    [[nodiscard]] Eigen::Vector2d inArena(double x, double y) const;
    [[nodiscard]] Spot moved(double x, double y) const { return {inArena(x, y), quarter, base}; }
};

/// The area behind a corridor's wall. The origin of its frame is the middle of that wall.
struct Strip {
    Spot frame;
    double length = 0.0, depth = 0.0;
};

/// A building while it is being generated.
class Plan {
public:
    Plan(const BuildingSettings& settings, std::uint64_t seed);

    BuildingSettings settings;
    Random random;
    Arena arena;
    BuildingWays ways;
    double roomDepth = 4.0;        ///< depth of the rooms around the ring [m]
    double roomLength = 5.4;       ///< approximate length of a room along the corridor [m]
    std::vector<double> shaftsAt;  ///< where each storey's ramp begins along its strip [m]

    [[nodiscard]] static double rounded(double value);
    /// Returns a random length, rounded to millimetres [m]. @p dice: those of the plan or of one room.
    [[nodiscard]] static double length(Random& dice, double least, double most);

    /// Adds @p element under a unique name at (x, y) of @p spot. @p up: height above its floor [m]. @p turn:
    /// rotation [degrees].
    Element& add(Element element, const Spot& spot, double x, double y, double up = 0.0, double turn = 0.0);
    /// Adds a wall from @p first to @p last along x of @p spot [m]. Adds none if it would be shorter than 1
    /// cm.
    void wall(const Spot& spot, double first, double last, double y = 0.0, double height = Clear,
              Material material = Material::Plaster);
    /// Adds a wall from @p first to @p last along y of @p spot, at @p x [m].
    void partition(const Spot& spot, double x, double first, double last, double height = Clear);

    /// Returns the dice for the next room. In a building of twins, all rooms get the same dice.
    [[nodiscard]] Random roomDice();
    [[nodiscard]] bool troubled() const { return settings.troubles && !settings.smooth; }

    /// Returns the four strips around the ring of a storey: south, west, north, east.
    [[nodiscard]] std::array<Strip, 4> outerStrips(int storey) const;
    /// Returns the strip with the ramp up from @p storey: in the north for even storeys, in the south for odd
    /// ones.
    [[nodiscard]] Strip shaftStrip(int storey) const { return outerStrips(storey)[storey % 2 == 0 ? 2 : 0]; }

private:
    std::uint64_t m_roomSeed;
    std::array<int, ElementKindCount> m_count{};
};

// Steps of generating a building.
void layFloors(Plan& plan);               ///< adds slabs with holes above ramps, outer walls, and a ceiling
void buildShaft(Plan& plan, int storey);  ///< adds ramp and stairs from @p storey to the next
void buildOuterStrips(Plan& plan, int storey);  ///< adds rooms around the ring, or bare walls
/// Adds what the ring encloses, left and right of the cross corridor.
void buildBlocks(Plan& plan, int storey);
void furnishCorridors(Plan& plan, int storey);  ///< adds lamps and signs
void makeTrouble(Plan& plan, int storey);       ///< adds smoke, and people who walk
void layVictims(Plan& plan);

/// A room behind the wall at y = 0 of its frame. The wall belongs to the room and has its door.
struct Room {
    Spot frame;
    double length = 0.0, depth = 0.0;
    bool hall = false;  ///< whether it is a hall with pillars
};
void buildRoom(Plan& plan, const Room& room);
/// Builds only the room's wall towards the corridor. Returns the position of the door along it [m].
double buildFront(Plan& plan, const Room& room);
/// Builds rooms side by side from @p first to @p last along a strip. Builds a bare wall if no room fits.
void buildRow(Plan& plan, const Strip& strip, double first, double last);

}  // namespace leitstand::simulation::building
