#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/handin/map/occupancy_grid.h"

namespace leitstand {

/// A colour of the hand-in map.
struct Rgb {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Rgb&) const = default;
};

/// The colours that the rules for the GeoTIFF map require (2009 to 2016).
namespace map_colour {
inline constexpr Rgb Text{0, 44, 207};
inline constexpr Rgb Scale{0, 50, 140};
inline constexpr Rgb UnexploredLight{226, 226, 227};
inline constexpr Rgb UnexploredDark{237, 237, 238};
inline constexpr Rgb Grid{190, 190, 191};
inline constexpr Rgb Wall{0, 40, 120};
inline constexpr Rgb ExploredLeast{128, 128, 128};
inline constexpr Rgb ExploredMost{255, 255, 255};
inline constexpr Rgb ClearedLeast{180, 230, 180};
inline constexpr Rgb ClearedMost{130, 230, 130};
inline constexpr Rgb Victim{240, 10, 10};
inline constexpr Rgb UnconfirmedVictim{240, 100, 10};
inline constexpr Rgb Hazard{255, 100, 30};
inline constexpr Rgb Code{10, 10, 240};
inline constexpr Rgb Object{10, 240, 10};
inline constexpr Rgb Start{255, 200, 0};
inline constexpr Rgb Path{120, 0, 140};
inline constexpr Rgb Number{255, 255, 255};
}  // namespace map_colour

/// The mark for a find in a map.
struct MapMark {
    /// In order of importance: a kind is painted over all kinds that are listed after it.
    enum class Kind : std::uint8_t { Victim, UnconfirmedVictim, Hazard, Code, Object };
    Kind kind = Kind::Victim;
    std::uint32_t number = 0;  ///< number within the kind; the two kinds of victims are counted together
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< in the map [m]
};
/// The mark's name: "V1", "H2", "Q3", "O4".
[[nodiscard]] std::string nameOf(const MapMark& mark);

/// Where a robot started, and its heading then.
struct MapStart {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< in the map [m]
    double heading = 0.0;                             ///< counter-clockwise from the x axis of the map [rad]
};

/// Everything that is in a picture of the map.
struct MapDrawing {
    std::string title;  ///< name of the file; ASCII
    OccupancyGrid grid;
    /// Paths of robots in the map [m]; after a gap a new path begins.
    std::vector<std::vector<Eigen::Vector2d>> paths;
    std::vector<MapStart> starts;
    std::vector<MapMark> marks;
};

/// A rectangle of the map, given by its corners with the lowest and the highest coordinates [m].
struct MapArea {
    Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
};
/// Returns the area of everything in @p drawing, rounded outwards to whole metres, with 1 m more on each
/// side. Marks more than 100 m away from the rest are left out. Returns 2 m x 2 m around the origin when
/// @p drawing is empty.
[[nodiscard]] MapArea areaOf(const MapDrawing& drawing);

}  // namespace leitstand
