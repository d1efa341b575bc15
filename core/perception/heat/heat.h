#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/perception/pictures/picture.h"

namespace leitstand {

struct CameraInfoSample;

/// What body heat looks like to a thermal camera.
struct HeatSettings {
    double coolest = 27.5;   ///< of a body's skin, as seen [degrees C]
    double hottest = 40.5;   ///< what is hotter is a lamp or heater [degrees C]
    double contrast = 3.0;   ///< over the surroundings [K]
    int halo = 2;            ///< around hot things, where pixels are mixed [px]
    int minPixels = 6;       ///< smaller blobs are noise, or far lamps
    double minSize = 0.015;  ///< square root of a body's solid angle [rad]
    double maxSize = 1.2;    ///< larger ones are walls or the sun [rad]
    double lampSize = 0.15;  ///< hot things below are lamps, above heaters [rad]
};

/// A warm part of a thermal picture.
struct HeatBlob {
    enum class Kind : std::uint8_t { Body, Lamp, Heater, Other };
    Kind kind = Kind::Other;
    Eigen::Vector2d centre =
        Eigen::Vector2d::Zero();                   ///< weighted by the heat; first pixel's middle: 0.5 [px]
    int left = 0, top = 0, right = 0, bottom = 0;  ///< box, both ends within [px]
    int pixels = 0;
    double mean = 0.0, peak = 0.0;     ///< [degrees C]
    double width = 0.0, height = 0.0;  ///< of the box, as seen [rad]
    double size = 0.0;                 ///< square root of its solid angle [rad]
    bool cut = false;                  ///< it touches the picture's border: may be larger
    double confidence = 0.0;           ///< that it is a body, 0 to 1
};
/// "body", "lamp", "heater", "other".
[[nodiscard]] std::string toString(HeatBlob::Kind kind);

/// Returns the temperature around the warm things in @p picture [degrees C]: that of its coolest quarter,
/// since a near body fills most of it. 20 where nothing is measured.
[[nodiscard]] double surroundings(const ThermalPicture& picture);

/// Returns the warm things in @p picture, bodies first, then by confidence and size. Robots and station share
/// this detector. The angle of a pixel comes from @p camera; uncalibrated, 45 degrees across are assumed.
///
/// A body is within a band of temperatures and neither tiny nor huge. Lamps and heaters have a hot core; the
/// mixed pixels around it, which have all temperatures, belong to them. Heat alone cannot distinguish a
/// heater that is as warm as skin from a body.
[[nodiscard]] std::vector<HeatBlob> findHeat(const ThermalPicture& picture, const CameraInfoSample& camera,
                                             const HeatSettings& settings = {});

}  // namespace leitstand
