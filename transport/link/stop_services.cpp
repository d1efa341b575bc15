#include "transport/link/stop_services.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "core/robot/control/stop/service_stop.h"
#include "transport/services/navigation_messages.h"
#include "transport/services/service_client.h"
#include "transport/services/service_messages.h"

namespace leitstand {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds Lifespan{1'000};  ///< of a request: a release must not arrive late
constexpr milliseconds LookEvery{100};   ///< how often it is looked who offers the services

}  // namespace

struct StopServices::State {
    struct Part {
        explicit Part(const ServiceDescription& service)
            : stop(service), kind(serviceFacts(service.type)->kind) {}
        ServiceStop stop;  ///< under the mutex
        ServiceKind kind;
        std::vector<Guid> servers = {};              ///< of the thread that calls step()
        std::unique_ptr<ServiceClient> client = {};  ///< null: the node may not call it
        std::string problem = {};                    ///< why there is no client
    };

    void answered(Part& part, std::uint64_t tag, const Payload& answer) {
        const auto decoded = decodeAnswer(part.kind, *answer);
        if (!decoded) return;
        {
            const std::lock_guard lock(mutex);
            part.stop.answered(tag, *decoded, steadyNow());
        }
        changed();
    }
    void look(Part& part, SteadyTime now) {
        std::vector<Guid> servers = part.client->servers();
        std::sort(servers.begin(), servers.end());
        const bool anew =
            !std::includes(part.servers.begin(), part.servers.end(), servers.begin(), servers.end());
        part.servers = std::move(servers);
        const std::lock_guard lock(mutex);
        part.stop.offered(!part.servers.empty(), anew, now);
    }

    std::function<void()> changed;
    mutable std::mutex mutex;  ///< never held while anything is written
    std::vector<std::unique_ptr<Part>> parts;
    SteadyTime lookNext = {};  ///< of the thread that calls step()
};

StopServices::StopServices(std::unique_ptr<State> state) : m_state(std::move(state)) {}

StopServices::~StopServices() {
    for (const auto& part : m_state->parts) part->client.reset();  // its callback uses the rest
}

std::unique_ptr<StopServices> StopServices::create(Node& node, const RobotDescription& robot,
                                                   std::function<void()> changed) {
    std::unique_ptr<StopServices> services(new StopServices(std::make_unique<State>()));
    State& state = *services->m_state;
    state.changed = std::move(changed);
    for (const ServiceDescription& service : robot.services) {
        if (!stopRequest(service) && !releaseRequest(service)) continue;
        auto part = std::make_unique<State::Part>(service);
        const bool action = part->kind == ServiceKind::Navigate;
        auto client = ServiceClient::create(
            node,
            {.name = action ? actionNames(service.name, service.type).cancelGoal : service.name,
             .type = action ? CancelGoalType : service.type,
             .lifespan = Lifespan},
            [&state, its = part.get()](std::uint64_t tag, const Payload& answer) {
                state.answered(*its, tag, answer);
            });
        // The rest stops the robot all the same.
        if (client)
            part->client = std::move(client).value();
        else
            part->problem = client.error().text;
        state.parts.push_back(std::move(part));
    }
    return services;
}

void StopServices::stop(SteadyTime now) {
    const std::lock_guard lock(m_state->mutex);
    for (const auto& part : m_state->parts) part->stop.stop(now);
}

void StopServices::release(SteadyTime now) {
    const std::lock_guard lock(m_state->mutex);
    for (const auto& part : m_state->parts) part->stop.release(now);
}

void StopServices::hold(SteadyTime now) {
    const std::lock_guard lock(m_state->mutex);
    for (const auto& part : m_state->parts) {
        if (part->stop.status().stage == StopServiceStatus::Stage::Idle) part->stop.stop(now);
    }
}

bool StopServices::step(SteadyTime now) {
    const bool looks = now >= m_state->lookNext;
    if (looks) m_state->lookNext = now + LookEvery;
    bool revoked = false;
    for (const auto& part : m_state->parts) {
        if (!part->client) continue;
        if (looks) m_state->look(*part, now);
        std::optional<ServiceStop::Call> call;
        {
            const std::lock_guard lock(m_state->mutex);
            call = part->stop.due(now);
            revoked = part->stop.takeRevoked() || revoked;
        }
        // A call that fails is made again with the next repetition.
        if (call) static_cast<void>(part->client->call(encodeRequest(part->kind, call->request), call->tag));
    }
    return revoked;
}

std::string StopServices::refusal() const {
    const std::lock_guard lock(m_state->mutex);
    for (const auto& part : m_state->parts) {
        if (!part->stop.refusal().empty()) return part->stop.refusal();
    }
    return {};
}

bool StopServices::isReleasing() const {
    const std::lock_guard lock(m_state->mutex);
    return std::any_of(m_state->parts.begin(), m_state->parts.end(),
                       [](const auto& part) { return part->stop.isReleasing(); });
}

std::vector<StopServiceStatus> StopServices::status() const {
    const std::lock_guard lock(m_state->mutex);
    std::vector<StopServiceStatus> all;
    all.reserve(m_state->parts.size());
    for (const auto& part : m_state->parts) {
        all.push_back(part->stop.status());
        if (!part->client) all.back().message = part->problem;
    }
    return all;
}

}  // namespace leitstand
