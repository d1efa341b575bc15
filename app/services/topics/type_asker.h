#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/services/domain/seen_topic.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/messages/message_text.h"
#include "transport/dds/node.h"
#include "transport/services/service_client.h"

namespace leitstand {

using MessageTextPtr = std::shared_ptr<const MessageText>;

/// Knows what messages are made of: types that come with the station, and others, for which the nodes that
/// publish them are asked. Nodes answer from ROS 2 Iron on. Any thread.
class TypeAsker {
public:
    /// @p node must outlive this object.
    explicit TypeAsker(Node& node) : m_node(node) {}

    /// Returns the type of messages on @p topic. Empty: its node was asked and has not answered yet; call
    /// again. Error: nobody tells it.
    [[nodiscard]] std::optional<Result<MessageTextPtr>> text(const SeenTopic& topic);
    /// Makes text() ask again for types that it gave an error for.
    void forgetFailures();

    static constexpr std::size_t MostTypes = 256;
    static constexpr std::chrono::seconds Patience{5};

private:
    /// Shared with the callback of its client.
    struct Asked {
        std::mutex mutex;
        std::string type;
        std::optional<Result<MessageTextPtr>> answer;
    };
    struct Question {
        std::shared_ptr<Asked> asked = std::make_shared<Asked>();
        std::unique_ptr<ServiceClient> client;
        std::string node;
        SteadyTime since = steadyNow();
        SteadyTime sent{};  ///< when it was asked last; epoch: not yet
    };
    Question begin(const SeenTopic& topic);

    Node& m_node;
    std::mutex m_mutex;
    std::map<std::string, Question> m_questions;  ///< by type
};

}  // namespace leitstand
