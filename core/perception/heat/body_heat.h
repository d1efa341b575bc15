#pragma once

#include <vector>

#include "core/perception/heat/heat.h"

namespace leitstand {

/// What distinguishes a person from a lamp or heater of the same temperature.
struct BodyHeatSettings {
    double lukewarm = 2.2;   ///< least temperature of clothes over the surroundings [K]
    double mixed = 2.0;      ///< width of the border of mixed pixels around warm ones [px]
    double clothes = 0.012;  ///< least lukewarm surface of a person beside the visible skin [m2]
    double smallest = 0.03;  ///< least width of skin [m]
    double largest = 0.7;    ///< greatest width of skin [m]; larger things are heaters and walls
};

/// How a warm blob looks as part of a person at a distance.
struct BodyHeat {
    double across = 0.0;      ///< square root of the blob's surface [m]
    double clothes = 0.0;     ///< lukewarm surface that is connected to the blob [m2]
    bool clothesCut = false;  ///< clothes touch the picture's border: there may be more of them
    double likelihood = 0;    ///< that it is a person, 0 to 1: low for a bare and even surface, as of a lamp
};

/// Judges whether @p blob of @p picture, as warm as a body and seen at @p range [m], is part of a person.
/// Skin is next to clothes, which are lukewarm: between the air and the skin. A lamp or heater as warm as
/// skin has an even surface that ends abruptly.
[[nodiscard]] BodyHeat judgeBody(const ThermalPicture& picture, const HeatBlob& blob, double range,
                                 const BodyHeatSettings& settings = {});

}  // namespace leitstand
