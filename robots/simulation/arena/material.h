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
    Foil,   ///< hides from cameras and the laser, not from infrared
    Skin,
    Glass,  ///< of lamps: shines
    Rubber,
    Pane,  ///< of windows and glass walls: hardly an echo, and only of what is near and straight ahead
};
inline constexpr int MaterialCount = 12;

/// How light, laser, heat and robots meet a material.
struct MaterialProperties {
    Eigen::Vector3f albedo = Eigen::Vector3f::Constant(0.5F);  ///< red, green, blue, 0 to 1
    float reflectivity = 0.5F;          ///< of a laser of 905 nm, 0 to 1; below 0.03 there is no echo
    float emissivity = 0.95F;           ///< thermal, 0 to 1
    float infraredTransmission = 0.0F;  ///< share of what is behind that an infrared camera sees
    bool solid = true;                  ///< stops robots
};

[[nodiscard]] const MaterialProperties& propertiesOf(Material material);
/// "plywood": the name in arena files.
[[nodiscard]] std::string toString(Material material);

}  // namespace leitstand::simulation
