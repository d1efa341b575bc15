#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/perception/omni/panorama.h"
#include "core/perception/pictures/contrast.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the title of the camera of @p stream: "Left camera". An infrared camera has "°C" only when it
/// measures temperatures. Null: "No camera".
[[nodiscard]] QString cameraTitle(const StreamDescription* stream);

/// Returns how a picture was processed, "contrast raised", so that nobody takes it for the original. Empty
/// for ContrastHelp::Off.
[[nodiscard]] QString contrastText(ContrastHelp help);

/// Where a camera looks and how to turn it, as a line in its picture.
struct PanWords {
    std::optional<double> pan, tilt;  ///< positive: left, down [rad]; empty: unknown
    QString keys;                     ///< keys that turn the camera: "Q E R V"; empty: none
    QString recentreKey;              ///< "C"; empty: none
    bool waiting = false;             ///< the station waits for the grant to turn cameras
    QString heldBy;                   ///< other station that has this grant; empty: none
};
/// Returns "pan 14° right · 5° down · Q E R V turn · C re-centres". Words about grants replace those about
/// keys.
[[nodiscard]] QString panText(const PanWords& words);
/// Returns panText() without keys, for little room.
[[nodiscard]] QString shortPanText(const PanWords& words);

/// A mark along the lower edge of a panorama.
struct AzimuthTick {
    double place = 0.0;  ///< 0 to 1 of the width
    bool major = false;
    QString text;  ///< "ahead", "left 90°"; empty for minor ones
};
/// Returns a tick every 30 degrees, with words every 90.
[[nodiscard]] std::vector<AzimuthTick> azimuthTicks(const PanoramaShape& shape);

}  // namespace leitstand
