#include "core/event/all_samples.h"
#include "messages/leitstand_msgs.h"
#include "messages/std_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

constexpr int MostQuality = 100;
constexpr int MostPixels = 65'535;  // wider than any picture

}  // namespace

StopCommandSample fromWire(const wire::leitstand_msgs::StopCommand& from, const Source&, Checks& checks) {
    return {checks.time("stamp", from.stamp), from.station, from.number, from.stop, from.releases};
}

void toWire(const StopCommandSample& from, wire::leitstand_msgs::StopCommand& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp), from.station, from.number, from.stop, from.releases};
}

ModeCommandSample fromWire(const wire::leitstand_msgs::ModeCommand& from, const Source&, Checks& checks) {
    checks.require(!from.mode.empty(), "mode", "expected a name");
    return {checks.time("stamp", from.stamp), from.station, from.mode};
}

void toWire(const ModeCommandSample& from, wire::leitstand_msgs::ModeCommand& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp), from.station, from.mode};
}

StreamCommandSample fromWire(const wire::leitstand_msgs::StreamCommand& from, const Source&, Checks& checks) {
    checks.require(from.rate >= 0.0 && std::isfinite(from.rate), "rate", "expected 0 Hz or more, found {}",
                   from.rate);
    return {checks.time("stamp", from.stamp),
            from.station,
            from.topic,
            from.enabled,
            from.rate,
            checks.size("quality", from.quality, MostQuality),
            checks.size("max_width", from.max_width, MostPixels)};
}

void toWire(const StreamCommandSample& from, wire::leitstand_msgs::StreamCommand& to, Buffer&,
            Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp),
          from.station,
          from.topic,
          from.enabled,
          checks.finite("rate", from.rate),
          checks.wireSize("quality", from.quality),
          checks.wireSize("max_width", from.maxWidth)};
}

PingSample fromWire(const wire::leitstand_msgs::Ping& from, const Source&, Checks& checks) {
    return {from.number, from.station, checks.time("sent", from.sent)};
}

void toWire(const PingSample& from, wire::leitstand_msgs::Ping& to, Buffer&, Checks& checks) {
    to = {from.number, from.station, checks.wireTime("sent", from.sent)};
}

DriveLockSample fromWire(const wire::std_msgs::Bool& from, const Source&, Checks&) {
    return {from.data};
}

void toWire(const DriveLockSample& from, wire::std_msgs::Bool& to, Buffer&, Checks&) {
    to.data = from.locked;
}

std::vector<Conversion> commandConversions() {
    return {
        conversion<wire::leitstand_msgs::StopCommand, StopCommandSample>(),
        conversion<wire::leitstand_msgs::ModeCommand, ModeCommandSample>(),
        conversion<wire::leitstand_msgs::StreamCommand, StreamCommandSample>(),
        conversion<wire::leitstand_msgs::Ping, PingSample>(),
        conversion<wire::std_msgs::Bool, DriveLockSample>(),
    };
}

}  // namespace leitstand::detail
