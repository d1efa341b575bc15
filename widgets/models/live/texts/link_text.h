#pragma once

#include <QString>

#include "core/robot/link/link_status.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// What a stream carries: "3D scans", "odometry".
[[nodiscard]] QString streamRoleText(StreamRole role);
/// A stream with its sensor, where a robot has several: "left pictures".
[[nodiscard]] QString streamText(StreamRole role, const std::string& sensor);
/// What a sensor is called: "left"; unknown ones by their own names.
[[nodiscard]] QString sensorText(const std::string& sensor);
/// "connected", "degraded", "lost", "not heard yet".
[[nodiscard]] QString linkStateText(LinkState state);
/// One thing that is wrong: "odometry 1.4 s old", "12 % of points lost".
[[nodiscard]] QString linkReasonText(const LinkReason& reason);
/// The worst thing that is wrong; empty when nothing is.
[[nodiscard]] QString worstReasonText(const LinkStatus& link);
/// Round trip, "22 ms"; empty when the robot answers no pings.
[[nodiscard]] QString roundTripText(const LinkStatus& link);
/// Loss of the stream that loses most, "4 % loss"; empty while there are no streams.
[[nodiscard]] QString lossShareText(const LinkStatus& link);
[[nodiscard]] Tone toneOf(const LinkStatus& link);

}  // namespace leitstand
