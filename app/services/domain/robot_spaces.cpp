#include "app/services/domain/robot_spaces.h"
#include "app/services/domain/topic_role.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/event/station_topics.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

/// What a namespace has of a robot's base.
struct Base {
    bool driven = false;    ///< something takes commands to drive
    bool odometry = false;  ///< as a topic directly below it
    bool tree = false;      ///< transforms of its own
    bool ours = false;      ///< speaks Leitstand's own messages
};

/// Parts of names of nodes that pass commands on. Where the nodes of a topic are unknown, as in a bag, their
/// private topics look like a namespace.
constexpr std::array<std::string_view, 5> Relays = {"controller", "mux", "smoother", "teleop", "monitor"};

bool isRelay(std::string_view space) {
    return std::any_of(Relays.begin(), Relays.end(),
                       [space](std::string_view one) { return space.find(one) != std::string_view::npos; });
}

bool isDirectlyBelow(std::string_view name, std::string_view space) {
    const std::size_t begin = space.empty() ? 1 : space.size() + 2;
    return name.size() > begin && name.find('/', begin) == std::string_view::npos;
}

void add(Base& base, const SeenTopic& topic, const std::string& space) {
    std::string remark;
    const auto role = roleOf(topic, remark);
    const bool direct = isDirectlyBelow(topic.name, space);
    base.ours |= topic.type.starts_with("leitstand_msgs/");
    base.tree |= direct && topic.type == "tf2_msgs/msg/TFMessage";
    base.driven |= role == StreamRole::DriveCommand || role == StreamRole::TrackCommand;
    base.odometry |= direct && role == StreamRole::Odometry;
}

}  // namespace

std::string namespaceOf(std::string_view name) {
    if (name.empty() || name.front() != '/') return {};
    const auto end = name.find('/', 1);
    return end == std::string_view::npos ? std::string() : std::string(name.substr(1, end - 1));
}

std::string spaceOf(const SeenTopic& topic) {
    const auto owner = std::find_if(topic.nodes.begin(), topic.nodes.end(), [&](const std::string& node) {
        return topic.name.size() > node.size() && topic.name.starts_with(node) &&
               topic.name[node.size()] == '/';
    });
    return namespaceOf(owner == topic.nodes.end() ? topic.name : *owner);
}

std::set<std::string> robotSpaces(const std::vector<SeenTopic>& topics) {
    std::map<std::string, Base> bases;
    for (const SeenTopic& topic : topics) {
        if (!topic.name.starts_with('/') || topic.name.starts_with(station_topic::Prefix)) continue;
        const std::string space = spaceOf(topic);
        add(bases[space], topic, space);
    }
    const Base root = bases[""];
    std::set<std::string> robots;
    for (const auto& [space, base] : bases) {
        if (space.empty()) continue;
        const bool surely = base.ours || base.tree;
        // Beside a robot without a namespace, odometry alone may be a camera's, and commands a controller's.
        const bool alone = root.driven || root.odometry ? base.driven && base.odometry && !isRelay(space)
                                                        : base.driven || base.odometry;
        if (surely || alone) robots.insert(space);
    }
    if (robots.empty() || root.driven || root.odometry) robots.insert("");
    return robots;
}

}  // namespace leitstand
