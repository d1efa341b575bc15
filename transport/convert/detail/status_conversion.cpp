#include "core/event/all_samples.h"
#include "messages/diagnostic_msgs.h"
#include "messages/leitstand_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/std_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

GasSample gas(double ppm, const Source& source, Checks& checks) {
    GasSample to;
    if (source.stream != nullptr && !source.stream->sensor.empty()) to.gas = source.stream->sensor;
    to.ppm = checks.finite("ppm", ppm);
    checks.require(ppm >= 0.0 && ppm <= 1e6, "ppm", "expected 0 to 1000000, found {}", ppm);
    return to;
}

double measured(double value) {
    return std::isfinite(value) ? value : Unknown;
}

}  // namespace

GasSample fromWire(const wire::leitstand_msgs::GasConcentration& from, const Source& source, Checks& checks) {
    GasSample to = gas(from.ppm, source, checks);
    to.header = checks.header(from.header);
    return to;
}

GasSample fromWire(const wire::std_msgs::Float32& from, const Source& source, Checks& checks) {
    return gas(from.data, source, checks);
}

GasSample fromWire(const wire::std_msgs::Float64& from, const Source& source, Checks& checks) {
    return gas(from.data, source, checks);
}

void toWire(const GasSample& from, wire::leitstand_msgs::GasConcentration& to, Buffer&, Checks& checks) {
    to = {checks.wireHeader(from.header), checks.finite("ppm", from.ppm)};
}

void toWire(const GasSample& from, wire::std_msgs::Float32& to, Buffer&, Checks& checks) {
    to.data = static_cast<float>(checks.finite("ppm", from.ppm));
}

/// Also accepts a charge that the driver reports in percent.
BatterySample fromWire(const wire::sensor_msgs::BatteryState& from, const Source&, Checks& checks) {
    using Status = BatterySample::Status;
    BatterySample to;
    to.header = checks.header(from.header);
    to.voltage = measured(from.voltage);
    to.current = measured(from.current);
    to.charge = measured(from.charge);
    to.capacity = measured(from.capacity);
    to.temperature = measured(from.temperature);
    const double fraction = from.percentage > 1.01F ? from.percentage / 100.0 : from.percentage;
    to.fraction = fraction >= 0.0 && fraction <= 1.01 ? std::min(fraction, 1.0) : Unknown;
    to.status = from.power_supply_status <= wire::sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_FULL_
                    ? static_cast<Status>(from.power_supply_status)
                    : Status::Unknown;
    to.present = from.present;
    to.location = from.location;
    return to;
}

void toWire(const BatterySample& from, wire::sensor_msgs::BatteryState& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.voltage = static_cast<float>(from.voltage);
    to.temperature = static_cast<float>(from.temperature);
    to.current = static_cast<float>(from.current);
    to.charge = static_cast<float>(from.charge);
    to.capacity = static_cast<float>(from.capacity);
    to.design_capacity = static_cast<float>(Unknown);
    to.percentage = static_cast<float>(from.fraction);
    to.power_supply_status = static_cast<std::uint8_t>(from.status);
    to.present = from.present;
    to.location = from.location;
}

DiagnosticsSample fromWire(const wire::diagnostic_msgs::DiagnosticArray& from, const Source& source,
                           Checks& checks) {
    DiagnosticsSample to;
    to.header = checks.header(from.header);
    const std::string ours = source.stream == nullptr ? std::string() : source.stream->hardwareId;
    to.statuses.reserve(from.status.size());
    for (const auto& one : from.status) {
        if (!one.hardware_id.starts_with(ours)) continue;
        DiagnosticStatus& status = to.statuses.emplace_back();
        status.level = checks.enumerator<DiagnosticStatus::Level>("status.level", one.level, 4);
        status.name = one.name;
        status.message = one.message;
        status.hardwareId = one.hardware_id;
        status.values.reserve(one.values.size());
        for (const auto& value : one.values) status.values.emplace_back(value.key, value.value);
    }
    return to;
}

void toWire(const DiagnosticsSample& from, wire::diagnostic_msgs::DiagnosticArray& to, Buffer&,
            Checks& checks) {
    to.header = checks.wireHeader(from.header);
    for (const DiagnosticStatus& one : from.statuses) {
        auto& status = to.status.emplace_back();
        status = {static_cast<std::uint8_t>(one.level), one.name, one.message, one.hardwareId, {}};
        for (const auto& [key, value] : one.values) status.values.push_back({key, value});
    }
}

ModeSample fromWire(const wire::leitstand_msgs::Mode& from, const Source&, Checks& checks) {
    checks.require(!from.mode.empty(), "mode", "expected a name");
    return {checks.header(from.header), from.mode, from.autonomous, from.reason, from.available};
}

void toWire(const ModeSample& from, wire::leitstand_msgs::Mode& to, Buffer&, Checks& checks) {
    to = {checks.wireHeader(from.header), from.mode, from.autonomous, from.reason, from.available};
}

BumpSample fromWire(const wire::leitstand_msgs::Bumps& from, const Source&, Checks& checks) {
    BumpSample to;
    to.header = checks.header(from.header);
    to.bumpers.reserve(from.bumpers.size());
    for (const auto& one : from.bumpers) to.bumpers.push_back({one.name, one.pressed, one.hits});
    return to;
}

void toWire(const BumpSample& from, wire::leitstand_msgs::Bumps& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    for (const Bumper& one : from.bumpers) to.bumpers.push_back({one.name, one.pressed, one.hits});
}

SightingSample fromWire(const wire::leitstand_msgs::Sightings& from, const Source&, Checks& checks) {
    SightingSample to;
    to.header = checks.header(from.header);
    to.sightings.reserve(from.sightings.size());
    for (const auto& one : from.sightings) {
        checks.require(!(one.confidence < 0.0 || one.confidence > 1.0), "sightings.confidence",
                       "expected 0 to 1, found {}", one.confidence);
        to.sightings.push_back({one.id, one.kind, checks.vector("sightings.position", one.position),
                                checks.known("sightings.deviation", one.deviation), one.confidence,
                                checks.known("sightings.value", one.value), one.text});
    }
    return to;
}

void toWire(const SightingSample& from, wire::leitstand_msgs::Sightings& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    for (const Sighting& one : from.sightings) {
        to.sightings.push_back({one.id, one.kind,
                                checks.wireVector<wire::geometry_msgs::Point>("position", one.position),
                                one.deviation, one.confidence, one.value, one.text});
    }
}

StopStateSample fromWire(const wire::leitstand_msgs::StopState& from, const Source&, Checks& checks) {
    const SampleHeader header = checks.header(from.header);
    return {header, from.number, from.station, from.stopped, from.standing, from.refused, from.stops};
}

void toWire(const StopStateSample& from, wire::leitstand_msgs::StopState& to, Buffer&, Checks& checks) {
    const auto header = checks.wireHeader(from.header);
    to = {header, from.number, from.station, from.stopped, from.standing, from.refused, from.stops};
}

PongSample fromWire(const wire::leitstand_msgs::Pong& from, const Source&, Checks& checks) {
    return {from.number, from.station, checks.time("sent", from.sent), checks.time("received", from.received),
            checks.time("replied", from.replied)};
}

void toWire(const PongSample& from, wire::leitstand_msgs::Pong& to, Buffer&, Checks& checks) {
    to = {from.number, from.station, checks.wireTime("sent", from.sent),
          checks.wireTime("received", from.received), checks.wireTime("replied", from.replied)};
}

RobotModelSample fromWire(const wire::std_msgs::String& from, const Source&, Checks& checks) {
    checks.require(from.data.size() <= RobotModelSample::MostBytes, "data",
                   "expected a model of at most {} bytes, found {}", RobotModelSample::MostBytes,
                   from.data.size());
    if (!checks.ok()) return {};
    return {from.data};
}

void toWire(const RobotModelSample& from, wire::std_msgs::String& to, Buffer&, Checks&) {
    to.data = from.urdf;
}

std::vector<Conversion> statusConversions() {
    return {
        conversion<wire::leitstand_msgs::GasConcentration, GasSample>(),
        conversion<wire::std_msgs::Float32, GasSample>(),
        conversion<wire::sensor_msgs::BatteryState, BatterySample>(),
        conversion<wire::diagnostic_msgs::DiagnosticArray, DiagnosticsSample>(),
        conversion<wire::leitstand_msgs::Mode, ModeSample>(),
        conversion<wire::leitstand_msgs::Bumps, BumpSample>(),
        conversion<wire::leitstand_msgs::Sightings, SightingSample>(),
        conversion<wire::leitstand_msgs::StopState, StopStateSample>(),
        conversion<wire::leitstand_msgs::Pong, PongSample>(),
        decoding<wire::std_msgs::Float64, GasSample>(),
        conversion<wire::std_msgs::String, RobotModelSample>(),
    };
}

}  // namespace leitstand::detail
