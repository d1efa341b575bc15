#include "core/event/all_samples.h"
#include "messages/leitstand_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

using wire::geometry_msgs::Point;

VictimSign sign(const char* field, const wire::leitstand_msgs::VictimSign& from, Checks& checks) {
    return {checks.enumerator<VictimSign::State>(field, from.state, 3), from.text,
            checks.known(field, from.value)};
}

wire::leitstand_msgs::VictimSign wireSign(const VictimSign& from) {
    return {static_cast<std::uint8_t>(from.state), from.text, from.value};
}

/// Returns @p value, a confidence from 0 to 1 or Unknown; error when it is neither.
double share(const char* field, double value, Checks& checks) {
    checks.require(!(value < 0.0 || value > 1.0), field, "expected 0 to 1, found {}", value);
    return value;
}

}  // namespace

FindSample fromWire(const wire::leitstand_msgs::Victim& from, const Source&, Checks& checks) {
    checks.require(from.number > 0, "number", "expected a number from 1");
    FindSample to;
    to.stamp = checks.time("stamp", from.stamp);
    to.station = from.station;
    to.number = from.number;
    to.status = checks.enumerator<FindSample::Status>("status", from.status, 3);
    to.found = checks.time("found", from.found);
    to.robot = from.robot;
    to.autonomous = from.autonomous;
    to.scan = from.scan;
    to.positionInScan = checks.vector("position_in_scan", from.position_in_scan);
    to.positionInMap = checks.vector("position_in_map", from.position_in_map);
    to.deviation = checks.known("deviation", from.deviation);
    to.form = sign("form", from.form, checks);
    to.motion = sign("motion", from.motion, checks);
    to.heat = sign("heat", from.heat, checks);
    to.sound = sign("sound", from.sound, checks);
    to.co2 = sign("co2", from.co2, checks);
    to.situation = from.situation;
    to.tag = from.tag;
    to.area = from.area;
    to.text = from.text;
    to.kind = checks.enumerator<FindSample::Kind>("kind", from.kind, 4);
    to.mergedInto = from.merged_into;
    for (const auto& one : from.evidence) {
        to.evidence.push_back(
            {one.kind, one.topic, one.sequence_number, checks.time("evidence.stamp", one.stamp)});
    }
    return to;
}

void toWire(const FindSample& from, wire::leitstand_msgs::Victim& to, Buffer&, Checks& checks) {
    to.stamp = checks.wireTime("stamp", from.stamp);
    to.station = from.station;
    to.number = from.number;
    to.status = static_cast<std::uint8_t>(from.status);
    to.found = checks.wireTime("found", from.found);
    to.robot = from.robot;
    to.autonomous = from.autonomous;
    to.scan = from.scan;
    to.position_in_scan = checks.wireVector<Point>("position_in_scan", from.positionInScan);
    to.position_in_map = checks.wireVector<Point>("position_in_map", from.positionInMap);
    to.deviation = from.deviation;
    to.form = wireSign(from.form);
    to.motion = wireSign(from.motion);
    to.heat = wireSign(from.heat);
    to.sound = wireSign(from.sound);
    to.co2 = wireSign(from.co2);
    to.situation = from.situation;
    to.tag = from.tag;
    to.area = from.area;
    to.text = from.text;
    to.kind = static_cast<std::uint8_t>(from.kind);
    to.merged_into = from.mergedInto;
    for (const VictimEvidence& one : from.evidence) {
        to.evidence.push_back(
            {one.kind, one.topic, one.sequence, checks.wireTime("evidence.stamp", one.stamp)});
    }
}

CandidateSample fromWire(const wire::leitstand_msgs::Candidate& from, const Source&, Checks& checks) {
    checks.require(from.id > 0, "id", "expected a number from 1");
    CandidateSample to;
    to.stamp = checks.time("stamp", from.stamp);
    to.station = from.station;
    to.id = from.id;
    to.kind = checks.enumerator<FindSample::Kind>("kind", from.kind, 4);
    to.scan = from.scan;
    to.positionInScan = checks.vector("position_in_scan", from.position_in_scan);
    to.positionInMap = checks.vector("position_in_map", from.position_in_map);
    to.deviation = checks.known("deviation", from.deviation);
    to.confidence = share("confidence", from.confidence, checks);
    to.victim = from.victim;
    to.dismissed = from.dismissed;
    for (const auto& one : from.cues) {
        to.cues.push_back({one.kind, one.robot, one.sensor, one.topic, one.sequence_number,
                           checks.time("cues.stamp", one.stamp), checks.known("cues.value", one.value),
                           share("cues.confidence", one.confidence, checks), one.text});
    }
    return to;
}

void toWire(const CandidateSample& from, wire::leitstand_msgs::Candidate& to, Buffer&, Checks& checks) {
    to.stamp = checks.wireTime("stamp", from.stamp);
    to.station = from.station;
    to.id = from.id;
    to.kind = static_cast<std::uint8_t>(from.kind);
    to.scan = from.scan;
    to.position_in_scan = checks.wireVector<Point>("position_in_scan", from.positionInScan);
    to.position_in_map = checks.wireVector<Point>("position_in_map", from.positionInMap);
    to.deviation = from.deviation;
    to.confidence = from.confidence;
    to.victim = from.victim;
    to.dismissed = from.dismissed;
    for (const Cue& one : from.cues) {
        to.cues.push_back({one.kind, one.robot, one.sensor, one.topic, one.sequence,
                           checks.wireTime("cues.stamp", one.stamp), one.value, one.confidence, one.text});
    }
}

std::vector<Conversion> victimConversions() {
    return {
        stationConversion<wire::leitstand_msgs::Victim, FindSample>(),
        stationConversion<wire::leitstand_msgs::Candidate, CandidateSample>(),
    };
}

}  // namespace leitstand::detail
