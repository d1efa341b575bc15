#include "core/robot/link/reception.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/base/phrases/coded_text.h"
#include "core/base/words.h"
#include "core/event/stream_role.h"
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

std::string namesOf(const ReceptionFault& fault) {
    const auto shown = static_cast<std::ptrdiff_t>(std::min(fault.names.size(), MostNames));
    std::string text = fmt::format("{}", fmt::join(fault.names.begin(), fault.names.begin() + shown, ", "));
    if (fault.names.size() > MostNames) text += ", ...";
    return text;
}

constexpr LogPhrase Mute = {"announced_no_topics",
                            translatable("leitstand::Hearing", "announced by {}, but none of its topics are"),
                            {"names"}};
constexpr LogPhrase Partial = {
    "announced_partial", translatable("leitstand::Hearing", "announced, but never came: {}"), {"names"}};
constexpr LogPhrase Silent = {
    "announced_silent", translatable("leitstand::Hearing", "announced, but nothing comes: {}"), {"names"}};

const LogPhrase& phraseOf(ReceptionFault::Kind kind) {
    switch (kind) {
        case ReceptionFault::Kind::Mute:
            return Mute;
        case ReceptionFault::Kind::Partial:
            return Partial;
        case ReceptionFault::Kind::Silent:
            break;
    }
    return Silent;
}

/// Returns the fault of a robot that was never heard, or is lost. Its nodes are judged separately: a hung one
/// must not hide behind one that was heard before.
std::optional<ReceptionFault> faultWhileDown(const RobotDescription& robot, LinkState link,
                                             const Announced& announced) {
    struct Process {
        std::vector<std::string> topics;
        bool due = false, received = false;
    };
    std::map<std::string, Process> processes;
    for (const AnnouncedWriter& writer : announced.writers) {
        if (!isJudged(writer, robot)) continue;
        Process& process = processes[writer.process];
        process.topics.push_back(writer.topic);
        process.due = process.due || writer.seconds >= ReceivedWithin;
        process.received = process.received || writer.received;
    }
    for (auto& [name, process] : processes) {
        // A process that was heard before has lost its link, which is reported as such.
        if (!process.due || process.received) continue;
        std::sort(process.topics.begin(), process.topics.end());
        return ReceptionFault{ReceptionFault::Kind::Silent, std::move(process.topics), ReceivedWithin};
    }
    if (!processes.empty() || link == LinkState::Lost) return std::nullopt;
    ReceptionFault mute{ReceptionFault::Kind::Mute, {}, ReceivedWithin};
    for (const MuteProcess& process : announced.mute) {
        if (process.seconds >= ReceivedWithin) mute.names.push_back(process.name);
    }
    if (mute.names.empty()) return std::nullopt;
    return mute;
}

/// Returns the fault of a robot that is heard: events and answers come even when no stream does.
std::optional<ReceptionFault> faultWhileUp(const RobotDescription& robot, const Announced& announced) {
    struct Topic {
        double seconds = 0.0;  ///< since its oldest writer was discovered [s]
        bool received = false, alwaysOn = false;
    };
    std::map<std::string, Topic> topics;
    for (const AnnouncedWriter& writer : announced.writers) {
        if (!isJudged(writer, robot)) continue;
        Topic& topic = topics[writer.topic];
        topic.seconds = std::max(topic.seconds, writer.seconds);
        topic.received = topic.received || writer.received;
        topic.alwaysOn =
            topic.alwaysOn || std::any_of(robot.streams.begin(), robot.streams.end(), [&](const auto& one) {
                return one.topic == writer.topic && streamFacts(one.role).alwaysOn;
            });
    }
    const bool any = isReceived(robot, announced);
    const double within = any ? TopicReceivedWithin : ReceivedWithin;
    ReceptionFault fault{any ? ReceptionFault::Kind::Partial : ReceptionFault::Kind::Silent, {}, 1e9};
    bool due = false;  // nothing comes at all: newer topics count as not heard too
    for (const auto& [name, topic] : topics) {
        if (topic.received || (any && (topic.seconds < within || !topic.alwaysOn))) continue;
        due = due || topic.seconds >= within;
        fault.names.push_back(name);
        fault.seconds = std::min(fault.seconds, topic.seconds);
    }
    if (!due) return std::nullopt;
    return fault;
}

}  // namespace

std::optional<ReceptionFault> receptionFaultOf(const RobotDescription& robot, LinkState link,
                                               const Announced& announced) {
    return isUp(link) ? faultWhileUp(robot, announced) : faultWhileDown(robot, link, announced);
}

bool isReceived(const RobotDescription& robot, const Announced& announced) {
    return std::any_of(
        announced.writers.begin(), announced.writers.end(),
        [&](const AnnouncedWriter& writer) { return writer.received && isJudged(writer, robot); });
}

bool isOver(const ReceptionFault& fault, LinkState link, const Announced& announced) {
    if (fault.kind == ReceptionFault::Kind::Mute) return isUp(link);
    return std::any_of(
        announced.writers.begin(), announced.writers.end(), [&](const AnnouncedWriter& writer) {
            return writer.received &&
                   std::find(fault.names.begin(), fault.names.end(), writer.topic) != fault.names.end();
        });
}

std::string toString(const ReceptionFault& fault) {
    return logged(phraseOf(fault.kind), namesOf(fault));
}

std::string worded(const ReceptionFault& fault) {
    return receptionText(toString(fault));
}

std::string receptionText(const std::string& reported) {
    const ReadPhrase read = readPhrase(reported, std::array{Mute, Silent, Partial});
    return read.phrase ? wordsOf("leitstand::Hearing", read) : reported;
}

bool RejoinPlan::isDue(const std::optional<ReceptionFault>& fault, bool may, SteadyTime now) {
    if (!fault || !may) return false;
    if (fault->kind == ReceptionFault::Kind::Partial) {
        const std::size_t before = m_tried.size();
        if (fault->seconds < FreshTopic) m_tried.insert(fault->names.begin(), fault->names.end());
        return m_tried.size() > before;
    }
    if (m_tries == static_cast<int>(Pauses.size()) || (m_tries > 0 && now < m_next)) return false;
    m_next = now + Pauses[static_cast<std::size_t>(m_tries)];
    ++m_tries;
    return true;
}

bool RejoinPlan::hasFailed(const std::optional<ReceptionFault>& fault, SteadyTime now) {
    if (!fault) return false;
    if (fault->kind != ReceptionFault::Kind::Partial)
        return m_tries == static_cast<int>(Pauses.size()) && now >= m_next && !std::exchange(m_failed, true);
    const bool tried = fault->seconds >= FreshTopic ||
                       std::all_of(fault->names.begin(), fault->names.end(),
                                   [this](const auto& name) { return m_tried.contains(name); });
    if (!tried) return false;
    const std::size_t before = m_failedTopics.size();
    m_failedTopics.insert(fault->names.begin(), fault->names.end());
    return m_failedTopics.size() > before;
}

void RejoinPlan::received() {
    m_tries = 0;
    m_failed = false;
}

}  // namespace leitstand
