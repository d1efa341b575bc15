#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/perception/omni/panorama.h"
#include "core/perception/pictures/contrast.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What the camera of @p stream is called; "°C" stands only where it measures temperatures. Null: "No
/// camera".
[[nodiscard]] QString cameraTitle(const StreamDescription* stream);

/// What was done to a picture, so that nobody takes it for what the camera sent; empty for nothing.
[[nodiscard]] QString contrastText(ContrastHelp help);

/// Where a camera looks and how it is turned, as a line in its picture.
struct PanWords {
    std::optional<double> pan, tilt;  ///< left, down [rad]
    QString keys;                     ///< that turn it: "Q E R V"; empty: none
    QString recentreKey;              ///< "C"; empty: none
    bool waiting = false;             ///< for the grant to turn cameras
    QString heldBy;                   ///< station that has it; empty: none
};
/// "pan 14° right · 5° down · Q E R V turn · C re-centres"; words about grants go before those about keys.
[[nodiscard]] QString panText(const PanWords& words);
/// The same without keys, where there is little room.
[[nodiscard]] QString shortPanText(const PanWords& words);

/// A mark along the lower edge of a panorama.
struct AzimuthTick {
    double place = 0.0;  ///< 0 to 1 of the width
    bool major = false;
    QString text;  ///< "ahead", "left 90°"; empty for minor ones
};
/// Every 30 degrees, every 90 with words.
[[nodiscard]] std::vector<AzimuthTick> azimuthTicks(const PanoramaShape& shape);

}  // namespace leitstand
