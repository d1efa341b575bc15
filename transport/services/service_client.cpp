#include "transport/services/service_client.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <optional>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "transport/services/service_messages.h"

namespace leitstand {
namespace {

constexpr int Depth = 10;                    // of the histories, as ROS 2's services have it
constexpr std::size_t MostOpen = 64;         // calls whose answers are waited for
constexpr std::size_t MostAnswer = 1 << 20;  // [B]

/// Whether the participant that @p guid belongs to runs on Cyclone DDS: vendor 1.16 (RTPS 2.5, 9.3.1.5).
bool isCyclone(const Guid& guid) {
    return guid.bytes[0] == 1 && guid.bytes[1] == 0x10;
}

bool ofOneParticipant(const Guid& one, const Guid& other) {
    return std::equal(one.bytes.begin(), one.bytes.begin() + 12, other.bytes.begin());
}

std::uint64_t randomIdentity() {
    std::random_device device;
    return (std::uint64_t{device()} << 32U | device()) | 1U;
}

}  // namespace

struct ServiceClient::State {
    /// A call that waits for its answer.
    struct Open {
        std::uint64_t tag = 0;
        bool inPayload = false;
        std::uint64_t request = 0;      ///< the writer's number for the request; with `inPayload`: ours
        Guid reader = {}, writer = {};  ///< ours when it was sent; servers name one of them
    };

    void receive(const ReceivedSample& sample);
    /// Takes the open call that @p matches out, and returns its tag; empty: there is none.
    template <class Matches>
    std::optional<std::uint64_t> close(Matches matches) {
        const std::lock_guard lock(mutex);
        const auto found = std::find_if(open.begin(), open.end(), matches);
        if (found == open.end()) return std::nullopt;
        const std::uint64_t tag = found->tag;
        open.erase(found);
        return tag;
    }

    std::string name;
    Answered answered;
    const std::uint64_t identity = randomIdentity();
    /// Guards what follows; held while a request is written, since its answer may come before write() ends.
    std::mutex mutex;
    std::uint64_t calls = 0;
    std::deque<Open> open;  ///< the oldest first
    std::unique_ptr<Publisher> requests;
    std::unique_ptr<Subscription> answers;
};

// Uses neither publisher nor subscription: answers to others come while those are made and destroyed.
void ServiceClient::State::receive(const ReceivedSample& sample) {
    if (sample.event.cdr->size() > MostAnswer) return;
    if (isCyclone(sample.writer)) {
        const auto split = splitHeader(*sample.event.cdr);
        if (!split || split->header.client != identity) return;
        const auto number = static_cast<std::uint64_t>(split->header.number);
        const auto tag = close([&](const Open& one) { return one.inPayload && one.request == number; });
        if (tag) answered(*tag, split->body);
        return;
    }
    if (!sample.related) return;
    const auto tag = close([&](const Open& one) {
        const Guid& asked = sample.related->endpoint;
        return !one.inPayload && one.request == sample.related->number &&
               (asked == one.reader || asked == one.writer);
    });
    if (tag) answered(*tag, sample.event.cdr);
}

ServiceClient::ServiceClient(std::unique_ptr<State> state) : m_state(std::move(state)) {}

ServiceClient::~ServiceClient() {
    m_state->answers.reset();  // its callback uses the rest
}

Result<std::unique_ptr<ServiceClient>> ServiceClient::create(Node& node, const ClientSettings& settings,
                                                             Answered answered) {
    std::unique_ptr<ServiceClient> client(new ServiceClient(std::make_unique<State>()));
    State& state = *client->m_state;
    state.name = settings.name;
    state.answered = answered ? std::move(answered) : [](std::uint64_t, const Payload&) {};
    const ServiceTopics topics = topicsOf(settings.name, settings.type);
    Qos qos;
    qos.depth = Depth;
    Qos dropped = qos;
    dropped.lifespan = std::chrono::duration<double>(settings.lifespan).count();
    auto requests = node.publisher({topics.request, topics.requestType, dropped, Flow::Immediate});
    if (!requests) return requests.error();
    state.requests = std::move(requests).value();
    auto answers = node.subscribe({topics.answer, topics.answerType, qos, Lane::Small},
                                  [&state](const ReceivedSample& sample) { state.receive(sample); });
    if (!answers) return answers.error();
    state.answers = std::move(answers).value();
    return client;
}

std::vector<Guid> ServiceClient::servers() const {
    std::vector<Guid> hearing = m_state->requests->readers();
    const std::vector<Guid> answering = m_state->answers->writers();
    std::erase_if(hearing, [&](const Guid& reader) {
        return std::none_of(answering.begin(), answering.end(),
                            [&](const Guid& writer) { return ofOneParticipant(reader, writer); });
    });
    return hearing;
}

Result<void> ServiceClient::call(const Payload& request, std::uint64_t tag) {
    const std::vector<Guid> all = servers();
    if (all.empty()) return Error{fmt::format("{}: nobody offers this service", m_state->name)};
    const bool inPayload = isCyclone(all.front());
    if (std::any_of(all.begin(), all.end(), [&](const Guid& one) { return isCyclone(one) != inPayload; })) {
        return Error{
            fmt::format("{}: is offered on Fast DDS and on Cyclone DDS; a call can be meant for one "
                        "of them only",
                        m_state->name)};
    }
    State& state = *m_state;
    const std::lock_guard lock(state.mutex);
    State::Open open{tag, inPayload, ++state.calls, state.answers->guid(), state.requests->guid()};
    if (inPayload) {
        const CallHeader header{state.identity, static_cast<std::int64_t>(open.request)};
        if (auto written = state.requests->write(withHeader(header, request)); !written) return written;
    } else {
        // The reader, as rmw_fastrtps says it since Galactic: servers wait until that one is matched.
        auto written = state.requests->write(request, SampleIdentity{open.reader, 0});
        if (!written) return written.error();
        open.request = *written;
    }
    state.open.push_back(open);
    if (state.open.size() > MostOpen) state.open.pop_front();
    return {};
}

}  // namespace leitstand
