#include "core/event/all_samples.h"
#include "messages/leitstand_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {

GrantSample fromWire(const wire::leitstand_msgs::Grant& from, const Source&, Checks& checks) {
    checks.require(!from.station.empty(), "station", "expected an identity");
    return {checks.time("stamp", from.stamp),
            from.station,
            from.title,
            checks.enumerator<GrantSample::Kind>("kind", from.kind, 3),
            checks.enumerator<GrantSample::Action>("action", from.action, 5),
            from.robot,
            from.other,
            from.term};
}

void toWire(const GrantSample& from, wire::leitstand_msgs::Grant& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp),
          from.station,
          from.title,
          static_cast<std::uint8_t>(from.kind),
          static_cast<std::uint8_t>(from.action),
          from.robot,
          from.other,
          from.term};
}

ClockSample fromWire(const wire::leitstand_msgs::MissionClock& from, const Source&, Checks& checks) {
    return {checks.time("stamp", from.stamp), from.station, from.running,
            checks.duration("elapsed", from.elapsed), checks.duration("limit", from.limit)};
}

void toWire(const ClockSample& from, wire::leitstand_msgs::MissionClock& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp), from.station, from.running,
          checks.wireDuration("elapsed", from.elapsed), checks.wireDuration("limit", from.limit)};
}

ClockOffsetSample fromWire(const wire::leitstand_msgs::ClockOffset& from, const Source&, Checks& checks) {
    return {checks.time("stamp", from.stamp), from.robot, checks.duration("ahead", from.ahead),
            checks.duration("uncertainty", from.uncertainty), checks.duration("round_trip", from.round_trip)};
}

void toWire(const ClockOffsetSample& from, wire::leitstand_msgs::ClockOffset& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp), from.robot, checks.wireDuration("ahead", from.ahead),
          checks.wireDuration("uncertainty", from.uncertainty),
          checks.wireDuration("round_trip", from.roundTrip)};
}

UndoSample fromWire(const wire::leitstand_msgs::Undo& from, const Source&, Checks& checks) {
    checks.require(from.event > 0, "event", "expected a sequence number from 1");
    return {checks.time("stamp", from.stamp), from.station, from.event, from.text};
}

void toWire(const UndoSample& from, wire::leitstand_msgs::Undo& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp), from.station, from.event, from.text};
}

CheckpointSample fromWire(const wire::leitstand_msgs::Checkpoint& from, const Source& source,
                          Checks& checks) {
    return {checks.time("stamp", from.stamp), from.sequence_number, from.version, {source.cdr, from.state}};
}

void toWire(const CheckpointSample& from, wire::leitstand_msgs::Checkpoint& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp), from.sequence, from.version, from.state.bytes};
}

NoteSample fromWire(const wire::leitstand_msgs::Note& from, const Source&, Checks& checks) {
    return {checks.time("stamp", from.stamp), from.station, from.robot, from.text};
}

void toWire(const NoteSample& from, wire::leitstand_msgs::Note& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp), from.station, from.robot, from.text};
}

MissionInfoSample fromWire(const wire::leitstand_msgs::MissionInfo& from, const Source&, Checks& checks) {
    return {checks.time("stamp", from.stamp),
            from.station,
            from.competition,
            from.team,
            from.country,
            from.mission,
            from.operators,
            from.area,
            from.profile};
}

void toWire(const MissionInfoSample& from, wire::leitstand_msgs::MissionInfo& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp),
          from.station,
          from.competition,
          from.team,
          from.country,
          from.mission,
          from.operators,
          from.area,
          from.profile};
}

SessionSample fromWire(const wire::leitstand_msgs::Session& from, const Source&, Checks& checks) {
    return {checks.time("stamp", from.stamp),
            from.station,
            from.title,
            from.start,
            from.mission,
            from.version,
            from.operators};
}

void toWire(const SessionSample& from, wire::leitstand_msgs::Session& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp),
          from.station,
          from.title,
          from.start,
          from.mission,
          from.version,
          from.operators};
}

AlarmSample fromWire(const wire::leitstand_msgs::Alarm& from, const Source&, Checks& checks) {
    return {checks.time("stamp", from.stamp),
            from.station,
            from.robot,
            from.key,
            checks.enumerator<AlarmSample::Severity>("severity", from.severity, 3),
            checks.enumerator<AlarmSample::State>("state", from.state, 3),
            from.text};
}

void toWire(const AlarmSample& from, wire::leitstand_msgs::Alarm& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp),
          from.station,
          from.robot,
          from.key,
          static_cast<std::uint8_t>(from.severity),
          static_cast<std::uint8_t>(from.state),
          from.text};
}

std::vector<Conversion> stationConversions() {
    return {
        stationConversion<wire::leitstand_msgs::Grant, GrantSample>(),
        stationConversion<wire::leitstand_msgs::MissionClock, ClockSample>(),
        stationConversion<wire::leitstand_msgs::MissionInfo, MissionInfoSample>(),
        stationConversion<wire::leitstand_msgs::ClockOffset, ClockOffsetSample>(),
        stationConversion<wire::leitstand_msgs::Undo, UndoSample>(),
        stationConversion<wire::leitstand_msgs::Checkpoint, CheckpointSample>(),
        stationConversion<wire::leitstand_msgs::Note, NoteSample>(),
        stationConversion<wire::leitstand_msgs::Session, SessionSample>(),
        stationConversion<wire::leitstand_msgs::Alarm, AlarmSample>(),
    };
}

}  // namespace leitstand::detail
