#include "transport/services/service_server.h"

#include <utility>

#include <fmt/format.h>

#include "transport/services/service_messages.h"

namespace leitstand {
namespace {

constexpr int Depth = 10;  // of the histories, as ROS 2's services have it

}  // namespace

struct ServiceServer::State {
    void receive(const ReceivedSample& sample) {
        const Payload answer = serve(sample.event.cdr);
        if (!answer) return;
        // The client's reader, where it says which; otherwise the writer of the request.
        const bool named = sample.related && sample.related->endpoint != Guid{};
        const SampleIdentity asked{named ? sample.related->endpoint : sample.writer, sample.writerSequence};
        static_cast<void>(answers->write(answer, asked));
    }

    ServeRaw serve;
    std::unique_ptr<Publisher> answers;
    std::unique_ptr<Subscription> requests;  ///< last: destroyed first
};

ServiceServer::ServiceServer(std::unique_ptr<State> state) : m_state(std::move(state)) {}
ServiceServer::~ServiceServer() = default;

Result<std::unique_ptr<ServiceServer>> ServiceServer::create(Node& node, const std::string& name,
                                                             const std::string& type, Serve serve) {
    const ServiceFacts* const facts = serviceFacts(type);
    if (facts == nullptr) return Error{fmt::format("{}: {} is no type of services known here", name, type)};
    return createRaw(node, name, type,
                     [kind = facts->kind, serve = std::move(serve)](const Payload& bytes) -> Payload {
                         const auto request = decodeRequest(kind, *bytes);
                         if (!request) return nullptr;
                         const auto answer = serve(*request);
                         return answer ? encodeAnswer(kind, *answer) : nullptr;
                     });
}

Result<std::unique_ptr<ServiceServer>> ServiceServer::createRaw(Node& node, const std::string& name,
                                                                const std::string& type, ServeRaw serve) {
    auto state = std::make_unique<State>();
    state->serve = std::move(serve);
    const ServiceTopics topics = topicsOf(name, type);
    Qos qos;
    qos.depth = Depth;
    auto answers = node.publisher({topics.answer, topics.answerType, qos, Flow::Immediate});
    if (!answers) return answers.error();
    state->answers = std::move(answers).value();
    State& its = *state;
    auto requests = node.subscribe({topics.request, topics.requestType, qos, Lane::Small},
                                   [&its](const ReceivedSample& sample) { its.receive(sample); });
    if (!requests) return requests.error();
    state->requests = std::move(requests).value();
    return std::unique_ptr<ServiceServer>(new ServiceServer(std::move(state)));
}

}  // namespace leitstand
