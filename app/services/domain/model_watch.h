#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/services/domain/seen_topic.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Receives the models that robots publish (robot_description), so that what is guessed of a robot knows its
/// size. Any thread.
class ModelWatch {
public:
    /// @p node must outlive the watch.
    explicit ModelWatch(Node& node) : m_node(node) {}

    /// Subscribes to what among @p topics carries a model, at most MostTopics in all. Sets SeenTopic::model
    /// of those whose model was received.
    void complete(std::vector<SeenTopic>& topics);
    static constexpr std::size_t MostTopics = 64;

private:
    /// Shared with the callbacks.
    struct Received {
        std::mutex mutex;
        std::map<std::string, std::shared_ptr<const std::string>> models;  ///< by topic
    };
    Node& m_node;
    std::shared_ptr<Received> m_received = std::make_shared<Received>();
    std::mutex m_mutex;
    /// By topic; null: it cannot be subscribed.
    std::map<std::string, std::unique_ptr<Subscription>> m_subscriptions;
};

}  // namespace leitstand
