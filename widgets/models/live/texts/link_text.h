#pragma once

#include <QString>

#include "core/robot/link/link_status.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// Returns what a stream carries: "3D scans", "odometry".
[[nodiscard]] QString streamRoleText(StreamRole role);
/// Returns what a stream carries, for pictures with the name of the camera: "left pictures".
[[nodiscard]] QString streamText(StreamRole role, const std::string& sensor);
/// Returns the name of a sensor in the window's language: "left". Unknown sensors keep the names that they
/// have.
[[nodiscard]] QString sensorText(const std::string& sensor);
/// "connected", "degraded", "lost", "not heard yet".
[[nodiscard]] QString linkStateText(LinkState state);
/// Returns one fault of a link: "odometry 1.4 s old", "12 % of 3D scans lost".
[[nodiscard]] QString linkReasonText(const LinkReason& reason);
/// Returns the worst fault; empty when there is none.
[[nodiscard]] QString worstReasonText(const LinkStatus& link);
/// Returns the round trip, "22 ms"; empty when the robot answers no pings.
[[nodiscard]] QString roundTripText(const LinkStatus& link);
/// Returns the loss of the stream that loses most, "4 % loss"; stale streams do not count. Empty when no loss
/// is known.
[[nodiscard]] QString lossShareText(const LinkStatus& link);
[[nodiscard]] Tone toneOf(const LinkStatus& link);

}  // namespace leitstand
