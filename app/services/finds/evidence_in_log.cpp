#include "app/services/finds/evidence_in_log.h"

#include <chrono>

#include "app/services/finds/freezing.h"
#include "app/services/log/event_decoder.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/raw_event.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/raw_events.h"

namespace leitstand {
namespace {

/// Clocks usually agree, and two minutes hold many pictures.
constexpr std::chrono::seconds ClocksAgree{2}, ClocksDiffer{60};

bool hasStamp(const Event& event, Time stamp) {
    const auto* scan = event.sample.as<KeyScanSample>();
    return (scan != nullptr ? scan->stamp : evidenceOf("", event).stamp) == stamp;
}

std::uint64_t receivedAbout(BagReader& bag, EventDecoder& decoder, const VictimEvidence& evidence, Time about,
                            std::chrono::seconds reach) {
    BagQuery query;
    query.topics = {evidence.topic};
    query.from = about - reach;
    query.to = about + reach;
    std::uint64_t found = 0;
    const auto take = [&](const RawEvent& raw) {
        decoder.decode(raw, [&](const Event& event) {
            if (hasStamp(event, evidence.stamp)) found = raw.sequence;
        });
        return found == 0;
    };
    forEachRaw(bag, query, take);
    return found;
}

}  // namespace

std::uint64_t sequenceInLog(BagReader& bag, EventDecoder& decoder, const VictimEvidence& evidence,
                            const FindSample& find) {
    if (evidence.sequence != 0) return evidence.sequence;
    if (evidence.stamp == Time() || !decoder.knows(evidence.topic)) return 0;
    for (const auto reach : {ClocksAgree, ClocksDiffer}) {
        // By the robot's clock, and by that of the station that filed it.
        for (const Time about : {evidence.stamp, find.found}) {
            if (const auto there = receivedAbout(bag, decoder, evidence, about, reach)) return there;
        }
    }
    return 0;
}

}  // namespace leitstand
