#include "app/services/station/lines/robot_calls.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/words.h"
#include "transport/services/service_client.h"
#include "transport/services/service_messages.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Patience{3'000};

}  // namespace

bool isOperators(const ServiceDescription& service) {
    const ServiceFacts* const facts = serviceFacts(service.type);
    if (facts == nullptr || service.stop) return false;
    return facts->kind == ServiceKind::Switch || facts->kind == ServiceKind::Trigger;
}

struct RobotCalls::State {
    struct Open {
        const ServiceDescription* service = nullptr;
        bool value = false;
        SteadyTime since = {};
    };

    void answered(std::uint64_t tag, const Payload& answer) {
        Open open;
        {
            const std::lock_guard lock(mutex);
            const auto found = calls.find(tag);
            if (found == calls.end()) return;
            open = found->second;
            calls.erase(found);
        }
        const auto decoded = decodeAnswer(serviceFacts(open.service->type)->kind, *answer);
        ended({*open.service, open.value, decoded ? std::optional(*decoded) : std::nullopt});
    }
    [[nodiscard]] ServiceClient* client(const std::string& service) const {
        const auto found = clients.find(service);
        return found == clients.end() ? nullptr : found->second.get();
    }

    std::string robot;
    Ended ended;
    std::map<std::string, ServiceDescription> services;  // by name
    mutable std::mutex mutex;                            // guards what follows
    std::uint64_t newest = 0;
    std::map<std::uint64_t, Open> calls;                            // by tag
    std::map<std::string, std::unique_ptr<ServiceClient>> clients;  // by name; fixed. Last: destroyed first
};

RobotCalls::RobotCalls(std::unique_ptr<State> state) : m_state(std::move(state)) {}
RobotCalls::~RobotCalls() = default;

std::unique_ptr<RobotCalls> RobotCalls::create(Node& node, const RobotDescription& robot, Ended ended,
                                               std::vector<std::string>& problems) {
    std::unique_ptr<RobotCalls> calls(new RobotCalls(std::make_unique<State>()));
    State& state = *calls->m_state;
    state.robot = robot.name;
    state.ended = std::move(ended);
    for (const ServiceDescription& service : robot.services) {
        if (!isOperators(service)) continue;
        auto client = ServiceClient::create(
            node, {.name = service.name, .type = service.type, .lifespan = Patience},
            [&state](std::uint64_t tag, const Payload& answer) { state.answered(tag, answer); });
        if (!client) {
            problems.push_back(client.error().text);
            continue;
        }
        state.services.emplace(service.name, service);
        state.clients.emplace(service.name, std::move(client).value());
    }
    return calls;
}

Result<void> RobotCalls::call(const std::string& service, bool value) {
    ServiceClient* const client = m_state->client(service);
    if (client == nullptr)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: its file names no service {}"),
                                     m_state->robot, service)};
    const ServiceDescription& described = m_state->services.at(service);
    std::uint64_t tag = 0;
    {
        const std::lock_guard lock(m_state->mutex);
        tag = ++m_state->newest;
        m_state->calls[tag] = {&described, value, steadyNow()};
    }
    auto called = client->call(encodeRequest(serviceFacts(described.type)->kind, {value}), tag);
    if (!called) {
        const std::lock_guard lock(m_state->mutex);
        m_state->calls.erase(tag);
    }
    return called;
}

bool RobotCalls::isOffered(const std::string& service) const {
    const ServiceClient* const client = m_state->client(service);
    return client != nullptr && !client->servers().empty();
}

void RobotCalls::expire(SteadyTime now) {
    std::vector<Outcome> late;
    {
        const std::lock_guard lock(m_state->mutex);
        std::erase_if(m_state->calls, [&](const auto& call) {
            const State::Open& open = call.second;
            if (now - open.since < Patience) return false;
            late.push_back({*open.service, open.value, std::nullopt});
            return true;
        });
    }
    for (const Outcome& outcome : late) m_state->ended(outcome);
}

std::string worded(const RobotCalls::Outcome& outcome) {
    const ServiceDescription& service = outcome.service;
    std::string what = service.title.empty() ? service.name : service.title;
    if (serviceFacts(service.type)->kind == ServiceKind::Switch) {
        what = leitstand::fill(outcome.value ? translate("leitstand::Station", "{} on")
                                             : translate("leitstand::Station", "{} off"),
                               what);
    }
    if (!outcome.answer) return leitstand::fill(translate("leitstand::Station", "{}: no answer"), what);
    const std::string& words = outcome.answer->message;
    if (outcome.answer->accepted) {
        return words.empty() ? leitstand::fill(translate("leitstand::Station", "{}: done"), what)
                             : leitstand::fill(translate("leitstand::Station", "{}: done ({})"), what, words);
    }
    return words.empty() ? leitstand::fill(translate("leitstand::Station", "{}: refused"), what)
                         : leitstand::fill(translate("leitstand::Station", "{}: refused ({})"), what, words);
}

}  // namespace leitstand
