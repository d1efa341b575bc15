#include "app/services/recorded/review_log.h"

#include <algorithm>
#include <system_error>

#include "app/services/log/log_entry.h"
#include "app/services/log/mission_robots.h"
#include "app/services/log/replay/bag_history.h"
#include "app/services/recorded/made_map.h"
#include "core/base/time.h"
#include "core/base/words.h"
#include "core/event/raw_event.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/raw_events.h"
#include "core/mission/state/fold.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using Nanoseconds = std::chrono::nanoseconds;

constexpr Nanoseconds Longest = std::chrono::seconds(10), Shortest = std::chrono::milliseconds(200);
constexpr Nanoseconds Rung = std::chrono::milliseconds(500);  ///< between states kept within a segment
constexpr double SegmentBytes = 48e6;                         ///< of a segment, about
constexpr std::size_t Kept = 4;                               ///< segments

/// Returns a length with which a segment of the mission fits into memory, whatever its robots sent.
Nanoseconds lengthOf(const BagReader& bag) {
    double bytes = 1.0;
    for (const BagSession& session : bag.sessions()) {
        std::error_code problem;
        const auto size = fs::file_size(session.file, problem);
        if (!problem) bytes += static_cast<double>(size);
    }
    double seconds = 0.0;
    for (const BagSession& session : bag.sessions()) seconds += toSeconds(session.last - session.first);
    const double fitting = SegmentBytes * std::max(seconds, 1e-3) / bytes;
    const auto length = Nanoseconds(static_cast<std::int64_t>(std::clamp(fitting, 0.0, 10.0) * 1e9));
    return std::clamp(length, Shortest, Longest);
}

bool hasKeyScans(const BagReader& bag) {
    const auto& topics = bag.topics();
    return std::any_of(topics.begin(), topics.end(), [](const BagTopic& topic) {
        return topic.info.name == station_topic::KeyScans && topic.messages != 0U;
    });
}

/// Whether @p bag holds something that one of @p robots sent in one of @p roles.
bool holds(const BagReader& bag, const std::vector<RobotDescription>& robots,
           std::initializer_list<StreamRole> roles) {
    const auto& topics = bag.topics();
    return std::any_of(topics.begin(), topics.end(), [&](const BagTopic& topic) {
        if (topic.messages == 0U) return false;
        return std::any_of(robots.begin(), robots.end(), [&](const RobotDescription& robot) {
            return std::any_of(robot.streams.begin(), robot.streams.end(),
                               [&](const StreamDescription& stream) {
                                   return stream.topic == topic.info.name &&
                                          std::find(roles.begin(), roles.end(), stream.role) != roles.end();
                               });
        });
    });
}

/// Whether @p bag holds scans from which a map can be made: of a 3D scanner, or of a plane laser with
/// odometry.
bool holdsScans(const BagReader& bag, const std::vector<RobotDescription>& robots) {
    return holds(bag, robots, {StreamRole::Points}) ||
           (holds(bag, robots, {StreamRole::Ranges}) && holds(bag, robots, {StreamRole::Odometry}));
}

}  // namespace

/// The bag's past, merged with the events of makeMap().
class ReviewLog::History final : public MissionHistory {
public:
    explicit History(ReviewLog& log) : m_log(log), m_bag(*log.m_bag, log.m_decoder) {}

    [[nodiscard]] std::optional<StoredCheckpoint> checkpointUpTo(std::uint64_t sequence) override {
        // Stored checkpoints hold no key scans.
        return m_log.m_made.empty() ? m_bag.checkpointUpTo(sequence) : std::nullopt;
    }
    void events(std::uint64_t after, std::uint64_t upTo,
                const std::function<void(const Event&)>& take) override {
        auto made = std::upper_bound(
            m_log.m_made.begin(), m_log.m_made.end(), after,
            [](std::uint64_t sequence, const Event& one) { return sequence < one.sequence; });
        const auto giveBefore = [&](std::uint64_t sequence) {
            for (; made != m_log.m_made.end() && made->sequence < sequence; ++made) take(*made);
        };
        m_bag.events(after, upTo, [&](const Event& event) {
            giveBefore(event.sequence);
            take(event);
        });
        giveBefore(upTo + 1);
    }

private:
    ReviewLog& m_log;
    BagHistory m_bag;
};

struct ReviewLog::Segment {
    std::int64_t number = 0;
    std::uint64_t before = 0;  ///< last sequence before it
    std::vector<Event> events;
    std::vector<std::pair<std::size_t, MissionState>> ladder;  ///< states after so many of its events
    MissionState end;

    [[nodiscard]] std::size_t upTo(Time at) const {
        const auto found =
            std::upper_bound(events.begin(), events.end(), at,
                             [](Time time, const Event& event) { return time < event.received; });
        return static_cast<std::size_t>(found - events.begin());
    }
};

Result<std::unique_ptr<ReviewLog>> ReviewLog::open(const fs::path& mission) {
    auto bag = BagReader::open(mission);
    if (!bag) return bag.error();
    if ((*bag)->lastSequence() == 0)
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: there is nothing in it"), mission.string())};
    std::vector<std::string> warnings;
    auto robots = robotsOf(mission, **bag, warnings);
    // The folder keeps them by name; the robot with most streams comes first.
    std::stable_sort(robots.begin(), robots.end(), [](const RobotDescription& a, const RobotDescription& b) {
        return a.streams.size() > b.streams.size();
    });
    std::unique_ptr<ReviewLog> log(new ReviewLog(mission, std::move(bag).value(), std::move(robots)));
    log->m_warnings = std::move(warnings);
    return log;
}

ReviewLog::ReviewLog(fs::path mission, std::unique_ptr<BagReader> bag, std::vector<RobotDescription> robots)
    : m_mission(std::move(mission)),
      m_folder(fs::is_directory(m_mission) ? m_mission : m_mission.parent_path()),
      m_bag(std::move(bag)),
      m_decoder(std::move(robots)),
      m_length(lengthOf(*m_bag)) {}

ReviewLog::~ReviewLog() = default;

const std::vector<RobotDescription>& ReviewLog::robots() const {
    return m_decoder.robots();
}

Time ReviewLog::first() const {
    return m_bag->first();
}

Time ReviewLog::last() const {
    return m_bag->last();
}

std::vector<std::string> ReviewLog::problems() const {
    std::vector<std::string> problems = m_warnings;
    problems.insert(problems.end(), m_bag->problems().begin(), m_bag->problems().end());
    for (const auto& [topic, errors] : m_decoder.errors())
        problems.push_back(leitstand::fill(
            translate("leitstand::ReportText", "{} samples of {} make no sense, the last one: {}"),
            errors.count, topic, errors.last));
    return problems;
}

std::int64_t ReviewLog::numberOf(Time at) const {
    return (std::clamp(at, first(), last()) - first()) / m_length;
}

MissionState ReviewLog::startOf(std::int64_t number, std::uint64_t before) {
    if (const auto known = m_starts.find(number); known != m_starts.end()) return known->second;
    if (before == 0) return {};
    History history(*this);
    m_decoder.setDepths(false);
    MissionState state = leitstand::stateAt(history, before);
    m_decoder.setDepths(true);
    return state;
}

const ReviewLog::Segment& ReviewLog::segment(std::int64_t number) {
    const auto there = std::find_if(m_segments.begin(), m_segments.end(),
                                    [number](const auto& one) { return one->number == number; });
    if (there != m_segments.end()) {
        m_segments.splice(m_segments.begin(), m_segments, there);
        return *m_segments.front();
    }
    auto made = std::make_unique<Segment>();
    made->number = number;
    const Time from = first() + number * m_length;
    made->before = m_bag->sequenceAt(from) - 1;
    const std::uint64_t last = m_bag->sequenceAt(from + m_length) - 1;
    MissionState state = startOf(number, made->before);
    m_starts.insert_or_assign(number, state);
    made->ladder.emplace_back(0, state);
    if (last > made->before) {
        Time rung = from + Rung;
        History(*this).events(made->before, last, [&](const Event& event) {
            if (event.received >= rung) {
                made->ladder.emplace_back(made->events.size(), state);
                while (rung <= event.received) rung += Rung;
            }
            state = fold(std::move(state), event);
            made->events.push_back(event);
        });
    }
    m_starts.try_emplace(number + 1, state);
    made->end = std::move(state);
    m_segments.push_front(std::move(made));
    if (m_segments.size() > Kept) m_segments.pop_back();
    return *m_segments.front();
}

MissionState ReviewLog::stateAt(Time at) {
    if (at < first()) return {};
    const Segment& here = segment(numberOf(at));
    const std::size_t count = here.upTo(at);
    if (count == here.events.size()) return here.end;
    const auto rung = std::upper_bound(here.ladder.begin(), here.ladder.end(), count,
                                       [](std::size_t n, const auto& one) { return n < one.first; });
    const auto& [done, before] = *std::prev(rung);
    MissionState state = before;
    for (std::size_t i = done; i < count; ++i) state = fold(std::move(state), here.events[i]);
    return state;
}

void ReviewLog::events(Time after, Time upTo, const Take& take) {
    if (upTo < first() || upTo <= after) return;
    const std::int64_t last = numberOf(upTo);
    for (std::int64_t number = after < first() ? 0 : numberOf(after); number <= last; ++number) {
        const Segment& here = segment(number);
        const std::size_t begin = after < first() ? 0 : here.upTo(after), end = here.upTo(upTo);
        for (std::size_t i = begin; i < end; ++i) take(here.events[i]);
    }
}

std::optional<Event> ReviewLog::newest(const std::string& topic, Time at) {
    if (at < first()) return std::nullopt;
    const Segment& here = segment(numberOf(at));
    for (std::size_t i = here.upTo(at); i-- > 0;) {
        if (here.events[i].topic == topic) return here.events[i];
    }
    const auto [known, fresh] = m_before.try_emplace({topic, here.number});
    if (fresh && here.before > 0) {
        const auto raw = m_bag->lastUpTo(topic, here.before);
        // Of a topic that came to its end, several segments have the same one.
        const auto same = std::find_if(m_before.begin(), m_before.end(), [&](const auto& one) {
            return raw && one.second && one.first.first == topic && one.second->sequence == raw->sequence;
        });
        if (same != m_before.end()) {
            known->second = same->second;
        } else if (raw) {
            known->second = decodedAlone(*m_bag, m_decoder, *raw);
        }
        if (m_before.size() > 64) {  // pictures: those of a few segments are enough
            auto kept = m_before.extract(known);
            m_before.clear();
            return m_before.insert(std::move(kept)).position->second;
        }
    }
    return known->second;
}

void ReviewLog::all(const std::vector<std::string>& topics, const Progress& progress, const Take& take) {
    if (topics.empty()) return;
    BagQuery query;
    query.topics = topics;
    m_decoder.jump();
    const bool scans = std::find(topics.begin(), topics.end(), station_topic::KeyScans) != topics.end();
    auto made = scans ? m_made.begin() : m_made.end();
    const auto next = [&](const RawEvent& raw) {
        for (; made != m_made.end() && made->sequence < raw.sequence; ++made) take(*made);
        m_decoder.decode(raw, take);
        return true;
    };
    forEachRaw(*m_bag, query, next, progress);
    if (progress.cancelled()) return;
    for (; made != m_made.end(); ++made) take(*made);
}

std::optional<Time> ReviewLog::firstOf(const std::string& topic) {
    BagQuery query;
    query.topics = {topic};
    BagCursor cursor = m_bag->read(query);
    const auto raw = cursor.next();
    return raw ? std::optional(raw->received) : std::nullopt;
}

bool ReviewLog::lacksMap() const {
    return m_made.empty() && !hasKeyScans(*m_bag) && holdsScans(*m_bag, robots());
}

void ReviewLog::makeMap(const Progress& progress) {
    MadeMap map = madeMapOf(m_mission, progress);
    m_made = std::move(map.events);
    m_warnings.insert(m_warnings.end(), map.warnings.begin(), map.warnings.end());
    m_segments.clear();
    m_starts.clear();
}

bool isReviewable(const fs::path& mission) {
    const auto bag = BagReader::open(mission);
    if (!bag || (*bag)->lastSequence() == 0) return false;
    if (hasKeyScans(**bag)) return (*bag)->ours();
    std::vector<std::string> warnings;
    const auto robots = robotsOf(mission, **bag, warnings);
    return holdsScans(**bag, robots) &&
           holds(**bag, robots, {StreamRole::Odometry, StreamRole::Picture, StreamRole::Thermal});
}

bool isOfOthers(const fs::path& mission) {
    const auto bag = BagReader::open(mission);
    if (!bag || (*bag)->ours()) return false;
    const auto& topics = (*bag)->topics();
    return std::none_of(topics.begin(), topics.end(), [](const BagTopic& topic) {
        return topic.info.name.starts_with(station_topic::Prefix);
    });
}

}  // namespace leitstand
