#include "app/services/domain/service_guess.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "transport/services/service_messages.h"

namespace leitstand {
namespace {

/// The last part of a name in small letters, without '_': "/tb1/E_Stop" -> "estop".
std::string bareLeaf(const std::string& name) {
    std::string bare;
    for (const char c : name.substr(name.rfind('/') + 1)) {
        if (c != '_') bare += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return bare;
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// What STOP asks of a service of this name; empty: nothing.
std::optional<bool> partOf(const std::string& name, ServiceKind kind) {
    if (kind == ServiceKind::CancelGoal) return true;
    const std::string leaf = bareLeaf(name);
    if (!has(leaf, "estop") && !has(leaf, "emergencystop")) return std::nullopt;
    const bool releases = has(leaf, "reset") || has(leaf, "release") || has(leaf, "clear");
    if (kind == ServiceKind::Trigger) return !releases;
    return releases ? std::nullopt : std::optional(true);  // "set e_stop_reset" may mean either
}

/// "Goals of navigate_to_pose".
std::string titleOf(const std::string& name, ServiceKind kind) {
    if (kind != ServiceKind::CancelGoal) return {};
    const std::size_t end = name.find("/_action/");
    if (end == std::string::npos) return {};
    const std::string action = name.substr(0, end);
    return "Goals of " + action.substr(action.rfind('/') + 1);
}

/// The action whose goals are sent by the service @p name of @p type; empty: it is no such service.
std::optional<ServiceDescription> actionOf(const std::string& name, const std::string& type) {
    constexpr std::string_view SendGoal = "/_action/send_goal", OfType = "_SendGoal";
    if (!name.ends_with(SendGoal) || !type.ends_with(OfType)) return std::nullopt;
    ServiceDescription action{.name = name.substr(0, name.size() - SendGoal.size()),
                              .type = type.substr(0, type.size() - OfType.size())};
    const ServiceFacts* const facts = serviceFacts(action.type);
    return facts != nullptr && facts->kind == ServiceKind::Navigate ? std::optional(action) : std::nullopt;
}

}  // namespace

std::optional<ServiceDescription> guessService(const SeenTopic& topic) {
    if (!topic.read || !topic.obstacle.empty()) return std::nullopt;
    ServiceDescription service{.name = serviceOf(topic.name), .type = serviceTypeOf(topic.type)};
    if (auto action = actionOf(service.name, service.type)) return action;
    const ServiceFacts* const facts = serviceFacts(service.type);
    if (service.name.empty() || facts == nullptr) return std::nullopt;
    service.stop = partOf(service.name, facts->kind);
    service.title = titleOf(service.name, facts->kind);
    return service;
}

}  // namespace leitstand
