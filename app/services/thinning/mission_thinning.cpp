#include "app/services/thinning/mission_thinning.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <stop_token>
#include <tuple>
#include <utility>

#include "app/services/finds/evidence_in_log.h"
#include "app/services/finds/freezing.h"
#include "app/services/log/event_decoder.h"
#include "app/services/log/log_entry.h"
#include "app/services/log/mission_robots.h"
#include "core/event/event.h"
#include "core/event/find_sample.h"
#include "core/event/picture_samples.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"
#include "core/io/bag/raw_events.h"
#include "core/io/detail/unfinished.h"
#include "core/perception/pictures/video/video_packet.h"
#include "core/robot/robot_description.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/decode.h"

namespace leitstand {
namespace {

constexpr std::uint64_t EventsAFlush = 200;

/// All forms of @p bag's finds.
std::vector<FindSample> formsOf(BagReader& bag) {
    std::vector<FindSample> forms;
    BagQuery finds;
    finds.topics = {std::string(station_topic::Victims)};
    forEachRaw(bag, finds, [&forms](const RawEvent& event) {
        const auto sample = decodeStationEvent(event);
        const FindSample* form = sample ? sample->sample.as<FindSample>() : nullptr;
        if (form != nullptr) forms.push_back(*form);
        return true;
    });
    return forms;
}

/// Returns the sequences of all evidence of @p bag's finds, also of finds of other stations.
std::set<std::uint64_t> evidenceOf(BagReader& bag, const std::vector<RobotDescription>& robots,
                                   const std::stop_token& stop) {
    std::set<std::uint64_t> all;
    std::set<std::tuple<std::string, Time, Time>> reported;  // topic, stamp, find: each form repeats it
    EventDecoder decoder(robots);
    for (const FindSample& form : formsOf(bag)) {
        for (const VictimEvidence& one : form.evidence) {
            if (stop.stop_requested()) return all;
            const bool stays = one.topic.starts_with(station_topic::Prefix);
            if (one.sequence == 0 && (stays || !reported.emplace(one.topic, one.stamp, form.found).second))
                continue;
            const std::uint64_t sequence = sequenceInLog(bag, decoder, one, form);
            all.insert(sequence);
            if (!isPictureEvidence(one)) continue;
            for (const RawEvent& needed : videoUpTo(bag, decoder, one.topic, sequence))
                all.insert(needed.sequence);
        }
    }
    return all;
}

/// Returns how often a topic of @p role is kept [1/s]; negative: always.
double rateOf(StreamRole role, const ThinningSettings& settings) {
    switch (streamFacts(role).thinnedAs) {
        case ThinnedAs::Kept:
            return -1.0;
        case ThinnedAs::Cloud:
            return settings.clouds;
        case ThinnedAs::Ranges:
            return settings.ranges;
        case ThinnedAs::Picture:
            return settings.pictures;
        case ThinnedAs::Motion:
            return settings.motion;
        case ThinnedAs::Other:
            return settings.others;
    }
    return -1.0;
}

/// Decides event by event what is kept.
class Sieve {
public:
    Sieve(const std::vector<RobotDescription>& robots, std::set<std::uint64_t> evidence,
          const ThinningSettings& settings)
        : m_evidence(std::move(evidence)), m_decoder(robots) {
        for (const RobotDescription& robot : robots) {
            for (const StreamDescription& stream : robot.streams)
                m_rates[stream.topic] = rateOf(stream.role, settings);
        }
    }

    [[nodiscard]] bool keeps(const RawEvent& event) {
        if (event.topic == station_topic::Checkpoints) return false;
        if (event.topic.starts_with(station_topic::Prefix) || m_evidence.contains(event.sequence))
            return true;
        const auto rate = m_rates.find(event.topic);
        if (rate == m_rates.end() || rate->second < 0.0) return true;
        if (rate->second == 0.0) return false;
        if (!standsAlone(event)) return false;
        const auto [last, first] = m_last.try_emplace(event.topic, event.received);
        const std::chrono::duration<double> since = event.received - last->second;
        if (!first && since.count() >= 0.0 && since.count() < 1.0 / rate->second) return false;
        last->second = event.received;
        return true;
    }

private:
    /// Whether @p event can be decoded without those before it: of a video, key pictures alone.
    [[nodiscard]] bool standsAlone(const RawEvent& event) {
        bool alone = true;
        if (!isPictureType(event.type)) return alone;
        m_decoder.decode(event, [&](const Event& decoded) {
            const auto* const picture = decoded.sample.as<PictureSample>();
            alone = picture == nullptr || picture->video == nullptr || picture->video->key;
        });
        return alone;
    }

    std::set<std::uint64_t> m_evidence;
    EventDecoder m_decoder;
    std::map<std::string, double> m_rates;  ///< by topic
    std::map<std::string, Time> m_last;     ///< last kept event, by topic
};

}  // namespace

Result<ThinOutcome> thinMission(const std::filesystem::path& mission, const std::filesystem::path& out,
                                const ThinningSettings& settings, const Progress& progress) {
    std::error_code none;
    if (std::filesystem::exists(out, none))
        return Error{out.string() + ": is there already; expected a folder to be made"};
    auto bag = BagReader::open(mission);
    if (!bag) return bag.error();
    BagReader& from = **bag;
    ThinOutcome outcome;
    const auto robots = robotsOf(mission, from, outcome.problems);
    Sieve sieve(robots, evidenceOf(from, robots, progress.stop), settings);
    detail::Unfinished unfinished(out);  // destroyed after the writer has closed its files
    auto writer = BagWriter::open(out);
    if (!writer) return writer.error();
    if (auto kept = keepRobots(out, robots); !kept) return kept.error();
    for (const BagTopic& topic : from.topics()) (*writer)->addTopic(topic.info);
    BagQuery wanted;
    if (settings.seconds > 0.0) {
        wanted.to = from.first() + std::chrono::duration_cast<std::chrono::nanoseconds>(
                                       std::chrono::duration<double>(settings.seconds));
    }
    Result<void> written;
    const auto take = [&](RawEvent& event) {
        if (!sieve.keeps(event)) {
            ++outcome.left;
            return true;
        }
        (*writer)->write(std::move(event));
        if (++outcome.kept % EventsAFlush == 0) written = (*writer)->flush();
        return written.ok();
    };
    forEachRaw(from, wanted, take, progress);
    if (!written) return written.error();
    if (progress.cancelled()) return Error{out.string() + ": is not written: cancelled"};
    if (auto closed = (*writer)->close(); !closed) return closed.error();
    unfinished.done();
    for (const std::string& problem : from.problems()) outcome.problems.push_back(problem);
    return outcome;
}

}  // namespace leitstand
