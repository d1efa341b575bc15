#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/perception/pictures/picture.h"

namespace leitstand {

struct CameraInfoSample;

/// How body heat looks in a thermal camera.
struct HeatSettings {
    double coolest = 27.5;   ///< lowest apparent temperature of skin [degrees C]
    double hottest = 40.5;   ///< hotter things are lamps or heaters [degrees C]
    double contrast = 3.0;   ///< least difference from the surroundings [K]
    int halo = 2;            ///< width of the border of mixed pixels around hot things [px]
    int minPixels = 6;       ///< smaller blobs are noise, or far lamps
    double minSize = 0.015;  ///< smallest size of a body: square root of its solid angle [rad]
    double maxSize = 1.2;    ///< largest size of a body [rad]; larger things are walls or the sun
    double lampSize = 0.15;  ///< hot things smaller than this are lamps, larger ones heaters [rad]
};

/// A warm part of a thermal picture.
struct HeatBlob {
    enum class Kind : std::uint8_t { Body, Lamp, Heater, Other };
    Kind kind = Kind::Other;
    Eigen::Vector2d centre =
        Eigen::Vector2d::Zero();  ///< middle, weighted by heat [px]; the middle of the first pixel is 0.5
    /// Bounding box [px]; right and bottom are its last pixels.
    int left = 0, top = 0, right = 0, bottom = 0;
    int pixels = 0;
    double mean = 0.0, peak = 0.0;     ///< temperatures [degrees C]
    double width = 0.0, height = 0.0;  ///< angles that the box spans [rad]
    double size = 0.0;                 ///< square root of the blob's solid angle [rad]
    bool cut = false;                  ///< whether the blob touches the picture's border: it may be larger
    double confidence = 0.0;           ///< confidence that it is a body, 0 to 1
};
/// "body", "lamp", "heater", "other".
[[nodiscard]] std::string toString(HeatBlob::Kind kind);

/// Returns the temperature around the warm things in @p picture [degrees C]: a quarter of all pixels are
/// below it. It is not the median because a near body fills most of the picture. Returns 20 if nothing is
/// measured.
[[nodiscard]] double surroundings(const ThermalPicture& picture);

/// Returns the warm things in @p picture, sorted by kind (bodies first), then by confidence and size. Robots
/// and the station share this detector. The angle of a pixel follows from @p camera; if it is not calibrated,
/// 45 degrees across the picture are assumed.
///
/// A body has a temperature within a range and is neither tiny nor huge. Lamps and heaters have a hot core.
/// The mixed pixels around the core have all temperatures; they are left out. A heater that is as warm as
/// skin cannot be distinguished from a body by heat alone.
[[nodiscard]] std::vector<HeatBlob> findHeat(const ThermalPicture& picture, const CameraInfoSample& camera,
                                             const HeatSettings& settings = {});

}  // namespace leitstand
