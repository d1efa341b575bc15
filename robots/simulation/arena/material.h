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
    Black,  ///< swallows the laser
    Cloth,  ///< curtains, clothes: gives way to robots
    Paper,  ///< gives way to robots
    Foil,   ///< hides what is behind it from cameras and the laser, not from infrared cameras
    Skin,
    Glass,  ///< lamps: shines
    Rubber,
    Pane,  ///< windows, glass walls: weak echoes, only from near and at a right angle
};
inline constexpr int MaterialCount = 12;

/// How a material responds to light, laser, heat and robots.
struct MaterialProperties {
    Eigen::Vector3f albedo = Eigen::Vector3f::Constant(0.5F);  ///< red, green, blue, 0 to 1
    float reflectivity = 0.5F;          ///< of a laser of 905 nm, 0 to 1; below 0.03 there is no echo
    float emissivity = 0.95F;           ///< thermal, 0 to 1
    float infraredTransmission = 0.0F;  ///< share of the heat from behind it that passes
    bool solid = true;                  ///< stops robots
};

[[nodiscard]] const MaterialProperties& propertiesOf(Material material);
/// Returns the name in arena files: "plywood".
[[nodiscard]] std::string toString(Material material);

}  // namespace leitstand::simulation
