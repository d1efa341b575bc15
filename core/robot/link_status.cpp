#include "core/robot/link_status.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace leitstand {
namespace {

std::string wordsOf(StreamRole role) {
    switch (role) {
        case StreamRole::Imu:
            return "IMU";
        case StreamRole::Picture:
            return "pictures";
        case StreamRole::Thermal:
            return "thermal pictures";
        case StreamRole::CameraInfo:
            return "camera info";
        case StreamRole::StaticTransforms:
            return "static transforms";
        case StreamRole::StopState:
            return "stop state";
        default:
            return toString(role);
    }
}

std::string streamOf(const LinkReason& reason) {
    const bool camera = reason.role == StreamRole::Picture || reason.role == StreamRole::Thermal ||
                        reason.role == StreamRole::CameraInfo;
    return camera && !reason.sensor.empty() ? reason.sensor + " " + wordsOf(reason.role)
                                            : wordsOf(reason.role);
}

}  // namespace

std::string toString(LinkState state) {
    switch (state) {
        case LinkState::NeverSeen:
            return "never seen";
        case LinkState::Connected:
            return "connected";
        case LinkState::Degraded:
            return "degraded";
        case LinkState::Lost:
            return "lost";
    }
    return {};
}

std::string toString(const LinkReason& reason) {
    switch (reason.kind) {
        case LinkReason::Kind::Silent:
            return fmt::format("nothing heard for {:.1f} s", reason.value);
        case LinkReason::Kind::Stale:
            return fmt::format("{} {:.1f} s old", streamOf(reason), reason.value);
        case LinkReason::Kind::Late:
            return fmt::format("{} {:.1f} s late", streamOf(reason), reason.value);
        case LinkReason::Kind::Loss:
            return fmt::format("{:.0f} % of {} lost", 100.0 * reason.value, streamOf(reason));
        case LinkReason::Kind::Slow:
            return fmt::format("round trip {:.0f} ms", 1e3 * reason.value);
        case LinkReason::Kind::NoAnswer:
            return fmt::format("no answer to pings for {:.1f} s", reason.value);
    }
    return {};
}

std::string toString(const std::vector<LinkReason>& reasons) {
    std::string text;
    for (const LinkReason& reason : reasons) text += (text.empty() ? "" : ", ") + toString(reason);
    return text;
}

const StreamStatus* LinkStatus::stream(std::string_view topic) const {
    const auto found = std::find_if(streams.begin(), streams.end(),
                                    [&](const StreamStatus& one) { return one.topic == topic; });
    return found == streams.end() ? nullptr : &*found;
}

std::optional<ClockOffsetSample> clockOffsetOf(const LinkStatus& status, Time stamp) {
    if (!status.clock) return std::nullopt;
    ClockOffsetSample sample;
    sample.stamp = stamp;
    sample.robot = status.robot;
    sample.ahead = status.clock->ahead;
    // anywhere within the bounds is as likely as anywhere else
    const double deviation = static_cast<double>(status.clock->uncertainty.count()) / std::sqrt(3.0);
    sample.uncertainty = std::chrono::nanoseconds(std::llround(deviation));
    if (status.roundTrip)
        sample.roundTrip = std::chrono::nanoseconds(std::llround(1e9 * status.roundTrip->last));
    return sample;
}

}  // namespace leitstand
