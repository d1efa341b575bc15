#include "core/robot/team.h"

#include <string>

#include <fmt/format.h>

#include "core/event/stream_role.h"

namespace leitstand {
namespace {

bool isTransforms(StreamRole role) {
    return role == StreamRole::Transforms || role == StreamRole::StaticTransforms;
}

bool areDistinct(const RobotDescription& a, const StreamDescription& ofA, const RobotDescription& b,
                 const StreamDescription& ofB) {
    if (ofA.role != ofB.role) return false;
    if (isTransforms(ofA.role)) return a.tfPrefix == TfPrefix::Frame && b.tfPrefix == TfPrefix::Frame;
    return ofA.role == StreamRole::Diagnostics && !ofA.hardwareId.empty() && !ofB.hardwareId.empty() &&
           !ofA.hardwareId.starts_with(ofB.hardwareId) && !ofB.hardwareId.starts_with(ofA.hardwareId);
}

std::string remedy(StreamRole role) {
    if (isTransforms(role))
        return "give each a topic of its own, or frames that begin with its name and frames.prefix: frame";
    if (role == StreamRole::Diagnostics) return "tell them apart by hardware_id";
    return isCommand(role) ? "both would obey the same command" : "give each a topic of its own";
}

void compareTopics(const RobotDescription& a, const RobotDescription& b, std::string& clashes) {
    for (const StreamDescription& ofA : a.streams) {
        for (const StreamDescription& ofB : b.streams) {
            if (ofA.topic != ofB.topic || areDistinct(a, ofA, b, ofB)) continue;
            const StreamRole role = isCommand(ofA.role) ? ofA.role : ofB.role;
            clashes +=
                fmt::format("{} and {} share the topic {}: {}\n", a.name, b.name, ofA.topic, remedy(role));
        }
    }
}

}  // namespace

Result<void> checkTeam(std::span<const RobotDescription> robots) {
    std::string clashes;
    for (std::size_t i = 0; i < robots.size(); ++i) {
        for (std::size_t j = i + 1; j < robots.size(); ++j) {
            const RobotDescription& a = robots[i];
            const RobotDescription& b = robots[j];
            if (a.name == b.name) {
                clashes +=
                    fmt::format("two robots are named {}: expected a name of its own for each\n", a.name);
                continue;  // their topics are the same for that reason
            }
            if (a.letter == b.letter) {
                clashes +=
                    fmt::format("{} and {} both have the letter {}: expected one of its own for each\n",
                                a.name, b.name, a.letter);
            }
            compareTopics(a, b, clashes);
        }
    }
    if (clashes.empty()) return {};
    clashes.pop_back();
    return Error{clashes};
}

}  // namespace leitstand
