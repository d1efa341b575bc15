#pragma once

#include <vector>

#include "core/perception/heat/heat.h"

namespace leitstand {

/// What tells a person from a lamp or heater of the same temperature.
struct BodyHeatSettings {
    double lukewarm = 2.2;   ///< over the surroundings: clothes [K]
    double mixed = 2.0;      ///< around what is warm, where pixels are mixed [px]
    double clothes = 0.012;  ///< lukewarm surface of a person beside the skin that is seen, at least [m2]
    double smallest = 0.03;  ///< of skin, across [m]
    double largest = 0.7;    ///< ... larger things are heaters and walls [m]
};

/// How a warm blob would look as part of a person at a distance.
struct BodyHeat {
    double across = 0.0;      ///< square root of its surface [m]
    double clothes = 0.0;     ///< lukewarm surface that hangs together with it [m2]
    bool clothesCut = false;  ///< they touch the picture's border: there may be more of them
    double likelihood = 0;    ///< 0 to 1: a person's skin beside clothes near 1; bare and even: a lamp's
};

/// Judges @p blob of @p picture, a body by its temperature, seen at @p range [m]. Skin is beside clothes,
/// which are lukewarm: between the air and the skin. A lamp's or heater's surface of skin's temperature is
/// even and ends at once.
[[nodiscard]] BodyHeat judgeBody(const ThermalPicture& picture, const HeatBlob& blob, double range,
                                 const BodyHeatSettings& settings = {});

}  // namespace leitstand
