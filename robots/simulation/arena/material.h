#pragma once

#include <cstdint>
#include <string>

#include <Eigen/Core>

namespace leitstand::simulation {

/// What a surface is made of.
enum class Material : std::uint8_t {
    Concrete,
    Plywood,
    Plaster,
    Metal,
    Black,  ///< absorbs the laser
    Cloth,  ///< curtains and clothes: robots can push it aside
    Paper,  ///< robots can push it aside
    Foil,   ///< hides what is behind it from cameras and the laser, but not from infrared cameras
    Skin,
    Glass,  ///< of lamps: gives light
    Rubber,
    Pane,  ///< windows and glass walls: weak echoes, only from nearby and at a right angle
};
inline constexpr int MaterialCount = 12;

/// How a material responds to light, laser, heat and robots.
struct MaterialProperties {
    Eigen::Vector3f albedo = Eigen::Vector3f::Constant(0.5F);  ///< red, green and blue, each 0 to 1
    float reflectivity = 0.5F;  ///< reflectivity for a laser of 905 nm, 0 to 1; below 0.03 there is no echo
    float emissivity = 0.95F;   ///< thermal emissivity, 0 to 1
    float infraredTransmission = 0.0F;  ///< share of the heat radiation from behind that passes through
    bool solid = true;                  ///< whether it stops robots
};

[[nodiscard]] const MaterialProperties& propertiesOf(Material material);
/// Returns the name in arena files: "plywood".
[[nodiscard]] std::string toString(Material material);

}  // namespace leitstand::simulation
