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
    double coolest = 27.5;   ///< lowest temperature of a body's skin, as seen [degrees C]
    double hottest = 40.5;   ///< what is hotter is a lamp or heater [degrees C]
    double contrast = 3.0;   ///< least difference from the surroundings [K]
    int halo = 2;            ///< width of the border of mixed pixels around hot things [px]
    int minPixels = 6;       ///< smaller blobs are noise, or far lamps
    double minSize = 0.015;  ///< least square root of a body's solid angle [rad]
    double maxSize = 1.2;    ///< ... and the greatest [rad]; larger things are walls or the sun
    double lampSize = 0.15;  ///< hot things smaller than this are lamps, others heaters [rad]
};

/// A warm part of a thermal picture.
struct HeatBlob {
    enum class Kind : std::uint8_t { Body, Lamp, Heater, Other };
    Kind kind = Kind::Other;
    Eigen::Vector2d centre =
        Eigen::Vector2d::Zero();  ///< weighted by the heat [px]; the middle of the first pixel is 0.5
    int left = 0, top = 0, right = 0, bottom = 0;  ///< box [px]; right and bottom are its last pixels
    int pixels = 0;
    double mean = 0.0, peak = 0.0;     ///< [degrees C]
    double width = 0.0, height = 0.0;  ///< of the box, as seen [rad]
    double size = 0.0;                 ///< square root of the blob's solid angle [rad]
    bool cut = false;                  ///< the blob touches the picture's border: it may be larger
    double confidence = 0.0;           ///< that it is a body, 0 to 1
};
/// "body", "lamp", "heater", "other".
[[nodiscard]] std::string toString(HeatBlob::Kind kind);

/// Returns the temperature around the warm things in @p picture [degrees C]. A quarter of all pixels are
/// below it, since a near body fills most of the picture. 20 where nothing is measured.
[[nodiscard]] double surroundings(const ThermalPicture& picture);

/// Returns the warm things in @p picture, sorted by kind (bodies first), then confidence and size. Robots and
/// station share this detector. The angle of a pixel comes from @p camera; if it is not calibrated, 45
/// degrees across the picture are assumed.
///
/// A body is within a band of temperatures and neither tiny nor huge. Lamps and heaters have a hot core. The
/// mixed pixels around the core have all temperatures; they are left out. Heat alone cannot distinguish a
/// heater that is as warm as skin from a body.
[[nodiscard]] std::vector<HeatBlob> findHeat(const ThermalPicture& picture, const CameraInfoSample& camera,
                                             const HeatSettings& settings = {});

}  // namespace leitstand
