#pragma once

#include <QString>

#include "core/robot/link/link_status.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// Returns a text for what a stream contains: "3D scans", "odometry".
[[nodiscard]] QString streamRoleText(StreamRole role);
/// Returns a text for what a stream contains; for pictures, it has the name of the camera: "left pictures".
[[nodiscard]] QString streamText(StreamRole role, const std::string& sensor);
/// Returns the name of a sensor in the window's language: "left". Names of unknown sensors are not changed.
[[nodiscard]] QString sensorText(const std::string& sensor);
/// "connected", "degraded", "lost", "not heard yet".
[[nodiscard]] QString linkStateText(LinkState state);
/// Returns one fault of a link: "odometry 1.4 s old", "12 % of 3D scans lost".
[[nodiscard]] QString linkReasonText(const LinkReason& reason);
/// Returns the worst fault; empty when there is none.
[[nodiscard]] QString worstReasonText(const LinkStatus& link);
/// Returns the round trip, "22 ms"; empty when the robot does not answer pings.
[[nodiscard]] QString roundTripText(const LinkStatus& link);
/// Returns the loss of the stream that loses most, "4 % loss"; stale streams are ignored. Empty when no loss
/// is known.
[[nodiscard]] QString lossShareText(const LinkStatus& link);
[[nodiscard]] Tone toneOf(const LinkStatus& link);

}  // namespace leitstand
