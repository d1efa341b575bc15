#include "app/services/domain/model_watch.h"

#include <utility>

#include "app/services/domain/topic_lane.h"
#include "app/services/domain/topic_role.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "transport/convert/decode.h"

namespace leitstand {

void ModelWatch::complete(std::vector<SeenTopic>& topics) {
    const std::lock_guard lock(m_mutex);
    for (SeenTopic& topic : topics) {
        std::string ignored;
        if (!topic.written || roleOf(topic, ignored) != StreamRole::Model) continue;
        if (!m_subscriptions.contains(topic.name) && m_subscriptions.size() < MostTopics) {
            Qos qos = topic.qos;
            qos.depth = 1;
            qos.lifespan = qos.deadline = 0.0;
            auto subscription = m_node.subscribe(
                {.topic = topic.name, .type = topic.type, .qos = qos, .lane = laneOf(topic.type)},
                [received = m_received](const ReceivedSample& sample) {
                    StreamDescription stream;
                    stream.role = StreamRole::Model;
                    stream.topic = sample.event.topic;
                    stream.type = sample.event.type;
                    const auto decoded = decode(sample.event, stream);
                    if (!decoded) return;
                    auto model = std::make_shared<const std::string>(decoded->get<RobotModelSample>().urdf);
                    const std::lock_guard keeping(received->mutex);
                    received->models[sample.event.topic] = std::move(model);
                });
            m_subscriptions[topic.name] = subscription ? std::move(subscription).value() : nullptr;
        }
        const std::lock_guard reading(m_received->mutex);
        const auto found = m_received->models.find(topic.name);
        if (found != m_received->models.end()) topic.model = found->second;
    }
}

}  // namespace leitstand
