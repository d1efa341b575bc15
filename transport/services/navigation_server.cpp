#include "transport/services/navigation_server.h"

#include <utility>

#include "transport/services/service_messages.h"
#include "transport/services/service_server.h"

namespace leitstand {

struct NavigationServer::State {
    Calls calls;
    std::unique_ptr<Publisher> statuses, feedbacks;
    std::unique_ptr<ServiceServer> going, cancelling;  ///< last: destroyed first
};

NavigationServer::NavigationServer(std::unique_ptr<State> state) : m_state(std::move(state)) {}
NavigationServer::~NavigationServer() = default;

Result<std::unique_ptr<NavigationServer>> NavigationServer::create(Node& node, const std::string& name,
                                                                   Calls calls) {
    auto state = std::make_unique<State>();
    State& its = *state;
    its.calls = std::move(calls);
    const ActionNames names = actionNames(name, NavigateToPose);
    const Qos kept{.durability = Qos::Durability::TransientLocal};
    auto statuses = node.publisher({names.status, GoalStatusType, kept, Flow::Immediate});
    if (!statuses) return statuses.error();
    its.statuses = std::move(statuses).value();
    auto feedbacks = node.publisher({names.feedback, names.feedbackType, {.depth = 10}, Flow::Immediate});
    if (!feedbacks) return feedbacks.error();
    its.feedbacks = std::move(feedbacks).value();
    auto going = ServiceServer::createRaw(node, names.sendGoal, names.sendGoalType,
                                          [&its](const Payload& request) -> Payload {
                                              const auto goal = decodeGoal(*request);
                                              if (!goal) return nullptr;
                                              return encodeAcceptance(its.calls.go(*goal));
                                          });
    if (!going) return going.error();
    its.going = std::move(going).value();
    auto cancelling = ServiceServer::createRaw(
        node, names.cancelGoal, CancelGoalType, [&its](const Payload& request) -> Payload {
            const auto goal = decodeCancel(*request);
            if (!goal) return nullptr;
            return encodeAnswer(ServiceKind::CancelGoal, {its.calls.cancel(*goal), ""});
        });
    if (!cancelling) return cancelling.error();
    its.cancelling = std::move(cancelling).value();
    return std::unique_ptr<NavigationServer>(new NavigationServer(std::move(state)));
}

void NavigationServer::report(std::span<const GoalTracker::Report> goals) {
    static_cast<void>(m_state->statuses->write(encodeStatus(goals)));
}

void NavigationServer::progress(const NavigationProgress& progress) {
    static_cast<void>(m_state->feedbacks->write(encodeProgress(progress)));
}

}  // namespace leitstand
