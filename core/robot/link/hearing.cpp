#include "core/robot/link/hearing.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "core/base/said.h"
#include "core/base/words.h"

namespace leitstand {
namespace {

/// After each time that the station joins anew.
constexpr std::array Pauses = {std::chrono::seconds(5), std::chrono::seconds(15), std::chrono::seconds(0)};
constexpr std::size_t MostNames = 4;

/// Streams that come several times a second wherever they come.
bool isQuick(StreamRole role) {
    return comesSteadily(role) && role != StreamRole::Gas && role != StreamRole::Battery &&
           role != StreamRole::Diagnostics;
}

bool isOwn(const StreamDescription& stream, const RobotDescription& robot) {
    return stream.role != StreamRole::Transforms || stream.topic.starts_with("/" + robot.name + "/");
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
        case HearingFault::Kind::Silent:
            break;
    }
    return translatable("leitstand::Hearing", "announced, but nothing comes: {}");
}

}  // namespace

bool comesSteadily(StreamRole role) {
    switch (role) {
        case StreamRole::StaticTransforms:
        case StreamRole::Mode:
        case StreamRole::Bumps:
        case StreamRole::Sightings:
        case StreamRole::StopState:
        case StreamRole::Pong:
            return false;
        default:
            return !isCommand(role);
    }
}

std::optional<HearingFault> hearingFaultOf(const RobotDescription& robot, LinkState link,
                                           const Announced& announced) {
    if (link != LinkState::NeverSeen && link != LinkState::Lost) return std::nullopt;
    struct Process {
        std::vector<std::string> topics;
        bool due = false, heard = false;
    };
    std::map<std::string, Process> processes;
    for (const AnnouncedWriter& writer : announced.writers) {
        const bool quick = std::any_of(robot.streams.begin(), robot.streams.end(), [&](const auto& stream) {
            return stream.topic == writer.topic && isQuick(stream.role) && isOwn(stream, robot);
        });
        if (!quick) continue;
        Process& process = processes[writer.process];
        process.topics.push_back(writer.topic);
        process.due = process.due || writer.seconds >= HearWithin;
        process.heard = process.heard || writer.heard;
    }
    for (auto& [name, process] : processes) {
        // One that was heard and is not any more has lost its link, which is told as that.
        if (!process.due || process.heard) continue;
        std::sort(process.topics.begin(), process.topics.end());
        return HearingFault{HearingFault::Kind::Silent, std::move(process.topics)};
    }
    if (!processes.empty() || link == LinkState::Lost) return std::nullopt;
    HearingFault mute{HearingFault::Kind::Mute, {}};
    for (const MuteProcess& process : announced.mute) {
        if (process.seconds >= HearWithin) mute.names.push_back(process.name);
    }
    if (mute.names.empty()) return std::nullopt;
    return mute;
}

std::string toString(const HearingFault& fault) {
    return fmt::format(fmt::runtime(wordsOf(fault.kind)), namesOf(fault));
}

std::string worded(const HearingFault& fault) {
    return hearingWorded(toString(fault));
}

std::string hearingWorded(const std::string& said) {
    const SaidSentence found =
        knownEnding(said, std::array{wordsOf(HearingFault::Kind::Mute), wordsOf(HearingFault::Kind::Silent)});
    if (found.words == nullptr) return said;
    return withValues(translate("leitstand::Hearing", found.words), found.values);
}

bool RejoinPlan::isDue(bool fault, bool may, SteadyTime now) {
    const bool tried = m_tries > 0;
    if (!fault || !may || m_tries == static_cast<int>(Pauses.size()) || (tried && now < m_next)) return false;
    m_next = now + Pauses[static_cast<std::size_t>(m_tries)];
    ++m_tries;
    return true;
}

}  // namespace leitstand
