#pragma once

#include <vector>

#include "core/perception/heat/heat.h"

namespace leitstand {

/// What distinguishes a person from a lamp or heater of the same temperature.
struct BodyHeatSettings {
    double lukewarm = 2.2;   ///< least temperature of clothes above the surroundings [K]
    double mixed = 2.0;      ///< width of the border of mixed pixels around warm pixels [px]
    double clothes = 0.012;  ///< a person has at least this lukewarm surface next to visible skin [m2]
    double smallest = 0.03;  ///< least width of a piece of skin [m]
    double largest = 0.7;    ///< largest width of a piece of skin [m]; larger things are heaters and walls
};

/// How much a warm blob looks like part of a person at a certain distance.
struct BodyHeat {
    double across = 0.0;      ///< square root of the blob's surface [m]
    double clothes = 0.0;     ///< lukewarm surface that is connected to the blob [m2]
    bool clothesCut = false;  ///< whether clothes touch the picture's border: there may be more of them
    /// Likelihood that it is a person, 0 to 1: low if the surface is bare and even, as that of a lamp.
    double likelihood = 0;
};

/// Judges whether @p blob of @p picture is part of a person. It is as warm as a body and seen at @p range
/// [m]. Skin is next to clothes, which are lukewarm: between the temperatures of the air and the skin. A lamp
/// or heater as warm as skin has an even surface that ends abruptly.
[[nodiscard]] BodyHeat judgeBody(const ThermalPicture& picture, const HeatBlob& blob, double range,
                                 const BodyHeatSettings& settings = {});

}  // namespace leitstand
