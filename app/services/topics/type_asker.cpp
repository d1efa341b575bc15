#include "app/services/topics/type_asker.h"

#include <chrono>
#include <utility>

#include "core/base/words.h"
#include "transport/convert/message_catalog.h"
#include "transport/services/type_description.h"

namespace leitstand {
namespace {

Error unknown(const std::string& type) {
    return Error{leitstand::fill(
        translate(
            "leitstand::Topics",
            "The text of {} is not known here, and its publisher does not tell it (ROS 2 Iron and later do): "
            "its fields cannot be shown"),
        type)};
}

}  // namespace

TypeAsker::Question TypeAsker::begin(const SeenTopic& topic) {
    Question question;
    question.asked->type = topic.type;
    if (const MessageType* const known = findMessageType(topic.type); known != nullptr) {
        auto text = MessageText::parse(topic.type, known->definition);
        question.asked->answer = text ? Result<MessageTextPtr>(std::make_shared<const MessageText>(*text))
                                      : Result<MessageTextPtr>(text.error());
        return question;
    }
    if (topic.nodes.empty() || topic.typeHash.empty() || !topic.written) {
        question.asked->answer = Result<MessageTextPtr>(unknown(topic.type));
        return question;
    }
    question.node = topic.nodes.front();
    auto client = ServiceClient::create(
        m_node, {question.node + "/get_type_description", TypeDescriptionService},
        [asked = question.asked](std::uint64_t, const Payload& answer) {
            auto text = decodeTypeAnswer(*answer, asked->type);
            const std::lock_guard lock(asked->mutex);
            asked->answer =
                text ? Result<MessageTextPtr>(std::make_shared<const MessageText>(*text))
                     : Result<MessageTextPtr>(Error{leitstand::fill(
                           translate("leitstand::Topics", "What its publisher tells of {} is not read: {}"),
                           asked->type, text.error().text)});
        });
    if (client)
        question.client = std::move(client).value();
    else
        question.asked->answer = Result<MessageTextPtr>(client.error());
    return question;
}

std::optional<Result<MessageTextPtr>> TypeAsker::text(const SeenTopic& topic) {
    std::unique_ptr<ServiceClient> answered;  // destroyed without the lock: it waits for its callback
    const std::lock_guard lock(m_mutex);
    auto found = m_questions.find(topic.type);
    if (found == m_questions.end()) {
        if (m_questions.size() >= MostTypes) return Result<MessageTextPtr>(unknown(topic.type));
        found = m_questions.emplace(topic.type, begin(topic)).first;
    }
    Question& question = found->second;
    {
        const std::lock_guard reading(question.asked->mutex);
        if (question.asked->answer) {
            answered = std::move(question.client);
            return question.asked->answer;
        }
    }
    // A server that has not found this client yet misses the call without a word, or its answer is lost.
    constexpr std::chrono::milliseconds Again{500};
    const SteadyTime now = steadyNow();
    if (now - question.sent >= Again && !question.client->servers().empty() &&
        question.client->call(encodeTypeRequest({topic.type, topic.typeHash}), 1))
        question.sent = now;
    if (steadyNow() - question.since < Patience) return std::nullopt;
    const std::lock_guard writing(question.asked->mutex);
    question.asked->answer = Result<MessageTextPtr>(Error{leitstand::fill(
        translate("leitstand::Topics", "The text of {} is not known here, and {} does not answer what it is"),
        topic.type, question.node)});
    return question.asked->answer;
}

void TypeAsker::forgetFailures() {
    std::map<std::string, Question> ended;  // destroyed without the lock: clients wait for their callbacks
    const std::lock_guard lock(m_mutex);
    for (auto question = m_questions.begin(); question != m_questions.end();) {
        const auto next = std::next(question);
        std::unique_lock reading(question->second.asked->mutex);
        const bool failed = question->second.asked->answer && !question->second.asked->answer->ok();
        reading.unlock();
        if (failed) ended.insert(m_questions.extract(question));
        question = next;
    }
}

}  // namespace leitstand
