#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/perception/omni/panorama.h"
#include "core/perception/pictures/contrast.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the title of the camera of @p stream: "Left camera". The title of an infrared camera has "°C" only
/// if it measures temperatures. Null: "No camera".
[[nodiscard]] QString cameraTitle(const StreamDescription* stream);

/// Returns how a picture was processed, "contrast raised", so that nobody mistakes it for the original. Empty
/// for ContrastHelp::Off.
[[nodiscard]] QString contrastText(ContrastHelp help);

/// Where a camera looks and how to turn it, as text in its picture.
struct PanWords {
    std::optional<double> pan, tilt;  ///< positive: left, down [rad]; empty: unknown
    QString keys;                     ///< keys that turn the camera: "Q E R V"; empty: none
    QString recentreKey;              ///< "C"; empty: none
    bool waiting = false;             ///< whether the station waits for the grant to turn cameras
    QString heldBy;                   ///< title of another station that has this grant; empty: none
};
/// Returns "pan 14° right · 5° down · Q E R V turn · C re-centres". Words about grants appear instead of
/// those about keys.
[[nodiscard]] QString panText(const PanWords& words);
/// Returns panText() without keys, for narrow places.
[[nodiscard]] QString shortPanText(const PanWords& words);

/// A mark along the lower edge of a panorama.
struct AzimuthTick {
    double place = 0.0;  ///< position as a share of the width, 0 to 1
    bool major = false;
    QString text;  ///< "ahead", "left 90°"; empty for minor ticks
};
/// Returns a tick every 30 degrees, with words every 90.
[[nodiscard]] std::vector<AzimuthTick> azimuthTicks(const PanoramaShape& shape);

}  // namespace leitstand
