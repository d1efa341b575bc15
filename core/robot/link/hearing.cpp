#include "core/robot/link/hearing.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/base/said.h"
#include "core/base/words.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

/// Pause after each time that the station rejoins.
constexpr std::array Pauses = {std::chrono::seconds(5), std::chrono::seconds(15), std::chrono::seconds(5)};
constexpr std::size_t MostNames = 4;
/// A topic that was announced for longer is not worth leaving the network for [s].
constexpr double FreshTopic = 20.0;

bool isOwn(const StreamDescription& stream, const RobotDescription& robot) {
    return stream.role != StreamRole::Transforms || stream.topic.starts_with("/" + robot.name + "/");
}

/// Whether a stream is judged by whether it is heard.
bool isJudged(const AnnouncedWriter& writer, const RobotDescription& robot) {
    return std::any_of(robot.streams.begin(), robot.streams.end(), [&](const auto& stream) {
        return stream.topic == writer.topic && streamFacts(stream.role).quick && isOwn(stream, robot);
    });
}

bool isUp(LinkState link) {
    return link == LinkState::Connected || link == LinkState::Degraded;
}

std::string namesOf(const HearingFault& fault) {
    const auto shown = static_cast<std::ptrdiff_t>(std::min(fault.names.size(), MostNames));
    std::string text = fmt::format("{}", fmt::join(fault.names.begin(), fault.names.begin() + shown, ", "));
    if (fault.names.size() > MostNames) text += ", ...";
    return text;
}

/// Words for @p kind with a place for names; looked up by their English text.
constexpr const char* wordsOf(HearingFault::Kind kind) {
    switch (kind) {
        case HearingFault::Kind::Mute:
            return translatable("leitstand::Hearing", "announced by {}, but none of its topics are");
        case HearingFault::Kind::Partial:
            return translatable("leitstand::Hearing", "announced, but never came: {}");
        case HearingFault::Kind::Silent:
            break;
    }
    return translatable("leitstand::Hearing", "announced, but nothing comes: {}");
}

/// Returns the fault of a robot that was never heard, or is lost. Its nodes are judged separately: a hung one
/// must not hide behind one that was heard before.
std::optional<HearingFault> faultWhileDown(const RobotDescription& robot, LinkState link,
                                           const Announced& announced) {
    struct Process {
        std::vector<std::string> topics;
        bool due = false, heard = false;
    };
    std::map<std::string, Process> processes;
    for (const AnnouncedWriter& writer : announced.writers) {
        if (!isJudged(writer, robot)) continue;
        Process& process = processes[writer.process];
        process.topics.push_back(writer.topic);
        process.due = process.due || writer.seconds >= HearWithin;
        process.heard = process.heard || writer.heard;
    }
    for (auto& [name, process] : processes) {
        // A process that was heard before has lost its link, which is reported as such.
        if (!process.due || process.heard) continue;
        std::sort(process.topics.begin(), process.topics.end());
        return HearingFault{HearingFault::Kind::Silent, std::move(process.topics), HearWithin};
    }
    if (!processes.empty() || link == LinkState::Lost) return std::nullopt;
    HearingFault mute{HearingFault::Kind::Mute, {}, HearWithin};
    for (const MuteProcess& process : announced.mute) {
        if (process.seconds >= HearWithin) mute.names.push_back(process.name);
    }
    if (mute.names.empty()) return std::nullopt;
    return mute;
}

/// Returns the fault of a robot that is heard: events and answers come even when no stream does.
std::optional<HearingFault> faultWhileUp(const RobotDescription& robot, const Announced& announced) {
    struct Topic {
        double seconds = 0.0;  ///< since its oldest writer was discovered [s]
        bool heard = false, alwaysOn = false;
    };
    std::map<std::string, Topic> topics;
    for (const AnnouncedWriter& writer : announced.writers) {
        if (!isJudged(writer, robot)) continue;
        Topic& topic = topics[writer.topic];
        topic.seconds = std::max(topic.seconds, writer.seconds);
        topic.heard = topic.heard || writer.heard;
        topic.alwaysOn =
            topic.alwaysOn || std::any_of(robot.streams.begin(), robot.streams.end(), [&](const auto& one) {
                return one.topic == writer.topic && streamFacts(one.role).alwaysOn;
            });
    }
    const bool any = isHeard(robot, announced);
    const double within = any ? HearTopicWithin : HearWithin;
    HearingFault fault{any ? HearingFault::Kind::Partial : HearingFault::Kind::Silent, {}, 1e9};
    bool due = false;  // nothing comes at all: newer topics count as not heard too
    for (const auto& [name, topic] : topics) {
        if (topic.heard || (any && (topic.seconds < within || !topic.alwaysOn))) continue;
        due = due || topic.seconds >= within;
        fault.names.push_back(name);
        fault.seconds = std::min(fault.seconds, topic.seconds);
    }
    if (!due) return std::nullopt;
    return fault;
}

}  // namespace

std::optional<HearingFault> hearingFaultOf(const RobotDescription& robot, LinkState link,
                                           const Announced& announced) {
    return isUp(link) ? faultWhileUp(robot, announced) : faultWhileDown(robot, link, announced);
}

bool isHeard(const RobotDescription& robot, const Announced& announced) {
    return std::any_of(
        announced.writers.begin(), announced.writers.end(),
        [&](const AnnouncedWriter& writer) { return writer.heard && isJudged(writer, robot); });
}

bool isOver(const HearingFault& fault, LinkState link, const Announced& announced) {
    if (fault.kind == HearingFault::Kind::Mute) return isUp(link);
    return std::any_of(
        announced.writers.begin(), announced.writers.end(), [&](const AnnouncedWriter& writer) {
            return writer.heard &&
                   std::find(fault.names.begin(), fault.names.end(), writer.topic) != fault.names.end();
        });
}

std::string toString(const HearingFault& fault) {
    return fmt::format(fmt::runtime(wordsOf(fault.kind)), namesOf(fault));
}

std::string worded(const HearingFault& fault) {
    return hearingWorded(toString(fault));
}

std::string hearingWorded(const std::string& said) {
    const SaidSentence found =
        knownEnding(said, std::array{wordsOf(HearingFault::Kind::Mute), wordsOf(HearingFault::Kind::Silent),
                                     wordsOf(HearingFault::Kind::Partial)});
    if (found.words == nullptr) return said;
    return withValues(translate("leitstand::Hearing", found.words), found.values);
}

bool RejoinPlan::isDue(const std::optional<HearingFault>& fault, bool may, SteadyTime now) {
    if (!fault || !may) return false;
    if (fault->kind == HearingFault::Kind::Partial) {
        const std::size_t before = m_tried.size();
        if (fault->seconds < FreshTopic) m_tried.insert(fault->names.begin(), fault->names.end());
        return m_tried.size() > before;
    }
    if (m_tries == static_cast<int>(Pauses.size()) || (m_tries > 0 && now < m_next)) return false;
    m_next = now + Pauses[static_cast<std::size_t>(m_tries)];
    ++m_tries;
    return true;
}

bool RejoinPlan::hasFailed(const std::optional<HearingFault>& fault, SteadyTime now) {
    if (!fault) return false;
    if (fault->kind != HearingFault::Kind::Partial)
        return m_tries == static_cast<int>(Pauses.size()) && now >= m_next && !std::exchange(m_failed, true);
    const bool tried = fault->seconds >= FreshTopic ||
                       std::all_of(fault->names.begin(), fault->names.end(),
                                   [this](const auto& name) { return m_tried.contains(name); });
    if (!tried) return false;
    const std::size_t before = m_failedTopics.size();
    m_failedTopics.insert(fault->names.begin(), fault->names.end());
    return m_failedTopics.size() > before;
}

void RejoinPlan::heard() {
    m_tries = 0;
    m_failed = false;
}

}  // namespace leitstand
