#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/services/domain/seen_topic.h"
#include "app/services/job_queue.h"
#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/robot/model/model_body.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Returns how large the robot is that @p urdf describes, without its meshes. The error says why its size is
/// not known.
[[nodiscard]] Result<BodyExtent> extentOfModel(const std::string& urdf);

/// Receives the models that robots publish (robot_description), so that what is guessed of a robot knows its
/// size. Models are read on a thread of its own. Any thread.
class ModelWatch {
public:
    /// @p node must outlive the watch.
    explicit ModelWatch(Node& node);
    ~ModelWatch();
    ModelWatch(const ModelWatch&) = delete;
    ModelWatch& operator=(const ModelWatch&) = delete;

    /// Subscribes to what among @p topics carries a model, at most MostTopics in all. Sets SeenTopic::model
    /// of those whose model was received and read.
    void complete(std::vector<SeenTopic>& topics);
    static constexpr std::size_t MostTopics = 64;

private:
    /// What came on a topic.
    struct Topic {
        std::string urdf;     ///< the newest model
        bool atWork = false;  ///< whether a job is waiting to read it
        std::shared_ptr<const Result<BodyExtent>> extent;
    };
    void receive(const RawEvent& event);
    void read(const std::string& topic);

    Node& m_node;
    std::mutex m_mutex;  ///< guards the two that follow
    std::map<std::string, Topic> m_topics;
    /// By topic; null: it cannot be subscribed.
    std::map<std::string, std::unique_ptr<Subscription>> m_subscriptions;
    JobQueue m_jobs;
    std::jthread m_worker;  ///< the last member, so that it ends first
};

}  // namespace leitstand
