#pragma once

#include <vector>

#include "core/perception/heat/heat.h"

namespace leitstand {

/// What distinguishes a person from a lamp or heater of the same temperature.
struct BodyHeatSettings {
    double lukewarm = 2.2;   ///< of clothes over the surroundings [K]
    double mixed = 2.0;      ///< width of the mixed pixels around warm ones [px]
    double clothes = 0.012;  ///< least lukewarm surface of a person beside the visible skin [m2]
    double smallest = 0.03;  ///< of skin, across [m]
    double largest = 0.7;    ///< ... larger things are heaters and walls [m]
};

/// Appearance of a warm blob as part of a person at a distance.
struct BodyHeat {
    double across = 0.0;      ///< square root of its surface [m]
    double clothes = 0.0;     ///< lukewarm surface that is connected to it [m2]
    bool clothesCut = false;  ///< they touch the picture's border: there may be more of them
    double likelihood = 0;    ///< 0 to 1: near 1 for skin beside clothes; a bare and even surface is a lamp's
};

/// Judges @p blob of @p picture, a body by its temperature, seen at @p range [m]. Skin is next to clothes,
/// which are lukewarm: between the air and the skin. A lamp or heater as warm as skin has an even surface
/// that ends at once.
[[nodiscard]] BodyHeat judgeBody(const ThermalPicture& picture, const HeatBlob& blob, double range,
                                 const BodyHeatSettings& settings = {});

}  // namespace leitstand
