#include "core/robot/services/service_description.h"

#include <algorithm>
#include <iterator>

namespace leitstand {
namespace {

// The Create 3's own type has the fields of SetBool under other names (irobot_create_msgs/srv/EStop.srv).
constexpr ServiceFacts Table[] = {
    {"std_srvs/srv/SetBool", ServiceKind::Switch},
    {"std_srvs/srv/Trigger", ServiceKind::Trigger},
    {"irobot_create_msgs/srv/EStop", ServiceKind::Switch},
    {"action_msgs/srv/CancelGoal", ServiceKind::CancelGoal},
    {"nav2_msgs/action/NavigateToPose", ServiceKind::Navigate},
};

}  // namespace

std::span<const ServiceFacts> serviceTable() {
    return Table;
}

const ServiceFacts* serviceFacts(std::string_view type) {
    const auto* const found = std::find_if(std::begin(Table), std::end(Table),
                                           [&](const ServiceFacts& one) { return one.type == type; });
    return found == std::end(Table) ? nullptr : found;
}

std::optional<ServiceRequest> stopRequest(const ServiceDescription& service) {
    const ServiceFacts* const facts = serviceFacts(service.type);
    if (facts == nullptr) return std::nullopt;
    if (facts->kind == ServiceKind::Navigate)
        return service.stop.value_or(true) ? std::optional(ServiceRequest{true}) : std::nullopt;
    if (!service.stop) return std::nullopt;
    if (facts->kind == ServiceKind::Switch) return ServiceRequest{*service.stop};
    return *service.stop ? std::optional(ServiceRequest{true}) : std::nullopt;
}

std::optional<ServiceRequest> releaseRequest(const ServiceDescription& service) {
    const ServiceFacts* const facts = serviceFacts(service.type);
    if (facts == nullptr || !service.stop || facts->kind == ServiceKind::Navigate) return std::nullopt;
    if (facts->kind == ServiceKind::Switch) return ServiceRequest{!*service.stop};
    return *service.stop ? std::nullopt : std::optional(ServiceRequest{false});
}

}  // namespace leitstand
