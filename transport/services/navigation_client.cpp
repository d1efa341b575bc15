#include "transport/services/navigation_client.h"

#include <mutex>
#include <random>
#include <utility>

#include "transport/services/navigation_messages.h"
#include "transport/services/service_client.h"
#include "transport/services/service_messages.h"

namespace leitstand {
namespace {

using std::chrono::milliseconds;

/// A goal that arrives later would surprise the operator.
constexpr milliseconds Lifespan = GoalTracker::Patience;

/// A random identity (RFC 4122, version 4).
GoalId newGoal() {
    std::random_device device;
    GoalId id;
    for (std::uint8_t& byte : id) byte = static_cast<std::uint8_t>(device());
    id[6] = static_cast<std::uint8_t>((id[6] & 0x0FU) | 0x40U);
    id[8] = static_cast<std::uint8_t>((id[8] & 0x3FU) | 0x80U);
    return id;
}

}  // namespace

struct NavigationClient::State {
    void answered(std::uint64_t tag, const Payload& answer) {
        const auto accepted = decodeAcceptance(*answer);
        const std::lock_guard lock(mutex);
        if (accepted && tag == newest) goals.answered(goals.goal(), *accepted);
    }
    void status(const ReceivedSample& sample) {
        const auto reports = decodeStatus(*sample.event.cdr);
        const std::lock_guard lock(mutex);
        if (reports) goals.reported(*reports);
    }
    void feedback(const ReceivedSample& sample) {
        const auto progress = decodeProgress(*sample.event.cdr);
        const std::lock_guard lock(mutex);
        if (progress)
            goals.progressed(progress->id, progress->metres, progress->seconds, progress->recoveries);
    }

    mutable std::mutex mutex;  ///< guards what follows; never held while anything is written
    GoalTracker goals;
    std::uint64_t newest = 0;  ///< tag of the newest request
    std::unique_ptr<ServiceClient> sending, cancelling;
    std::unique_ptr<Subscription> statuses, feedbacks;
};

NavigationClient::NavigationClient(std::unique_ptr<State> state) : m_state(std::move(state)) {}

NavigationClient::~NavigationClient() {
    // Their callbacks use the rest.
    m_state->statuses.reset();
    m_state->feedbacks.reset();
    m_state->sending.reset();
}

Result<std::unique_ptr<NavigationClient>> NavigationClient::create(Node& node, const std::string& name) {
    std::unique_ptr<NavigationClient> client(new NavigationClient(std::make_unique<State>()));
    State& state = *client->m_state;
    const ActionNames names = actionNames(name, NavigateToPose);
    auto sending = ServiceClient::create(
        node, {.name = names.sendGoal, .type = names.sendGoalType, .lifespan = Lifespan},
        [&state](std::uint64_t tag, const Payload& answer) { state.answered(tag, answer); });
    if (!sending) return sending.error();
    state.sending = std::move(sending).value();
    auto cancelling = ServiceClient::create(
        node, {.name = names.cancelGoal, .type = CancelGoalType, .lifespan = Lifespan}, {});
    if (!cancelling) return cancelling.error();
    state.cancelling = std::move(cancelling).value();
    Qos kept{.durability = Qos::Durability::TransientLocal};
    auto statuses = node.subscribe({names.status, GoalStatusType, kept, Lane::Small},
                                   [&state](const ReceivedSample& sample) { state.status(sample); });
    if (!statuses) return statuses.error();
    state.statuses = std::move(statuses).value();
    auto feedbacks = node.subscribe({names.feedback, names.feedbackType, {}, Lane::Small},
                                    [&state](const ReceivedSample& sample) { state.feedback(sample); });
    if (!feedbacks) return feedbacks.error();
    state.feedbacks = std::move(feedbacks).value();
    return client;
}

Result<void> NavigationClient::go(const PoseSample& goal) {
    State& state = *m_state;
    const GoalId id = newGoal();
    const auto request = encodeGoal({id, goal});
    if (!request) return request.error();
    std::uint64_t tag = 0;
    {
        const std::lock_guard lock(state.mutex);
        tag = ++state.newest;
        state.goals.asked(id, steadyNow());
    }
    auto called = state.sending->call(*request, tag);
    if (!called) {
        const std::lock_guard lock(state.mutex);
        state.goals.answered(id, false);  // it never went out
    }
    return called;
}

void NavigationClient::cancel() {
    State& state = *m_state;
    GoalId id{};
    {
        const std::lock_guard lock(state.mutex);
        if (!state.goals.isOpen(steadyNow())) return;
        id = state.goals.goal();
        state.goals.cancelling();
    }
    // What comes of it is in the status.
    static_cast<void>(state.cancelling->call(encodeCancel(id), 0));
}

NavigationView NavigationClient::view() const {
    const std::vector<Guid> servers = m_state->sending->servers();
    const std::lock_guard lock(m_state->mutex);
    NavigationView view = m_state->goals.view(steadyNow());
    view.known = true;
    view.offered = !servers.empty();
    return view;
}

}  // namespace leitstand
