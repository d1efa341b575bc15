#include "app/services/domain/model_watch.h"

#include <exception>
#include <stop_token>
#include <utility>

#include "app/services/domain/topic_lane.h"
#include "app/services/domain/topic_role.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/model/urdf.h"
#include "transport/convert/decode.h"

namespace leitstand {

Result<BodyExtent> extentOfModel(const std::string& urdf) {
    auto model = readUrdf(urdf, "model");
    if (!model) return Error{"it cannot be drawn: " + model.error().text};
    return extentOf(bodyOf(std::move(model).value(), "base_link",
                           [](const std::string& uri) -> Result<TriangleMesh> { return Error{uri}; }));
}

ModelWatch::ModelWatch(Node& node)
    : m_node(node), m_worker([this](const std::stop_token& stop) { m_jobs.work(stop); }) {}

ModelWatch::~ModelWatch() {
    m_subscriptions.clear();  // no callback submits a job after this
}

void ModelWatch::receive(const RawEvent& event) {
    StreamDescription stream;
    stream.role = StreamRole::Model;
    stream.topic = event.topic;
    stream.type = event.type;
    const auto decoded = decode(event, stream);
    if (!decoded) return;
    const std::lock_guard lock(m_mutex);
    Topic& topic = m_topics[event.topic];
    if (topic.urdf == decoded->get<RobotModelSample>().urdf) return;
    topic.urdf = decoded->get<RobotModelSample>().urdf;
    if (std::exchange(topic.atWork, true)) return;
    m_jobs.submit([this, name = event.topic](const std::stop_token&) { read(name); });
}

void ModelWatch::read(const std::string& topic) {
    std::string urdf;
    {
        const std::lock_guard lock(m_mutex);
        urdf = m_topics[topic].urdf;
        m_topics[topic].atWork = false;  // a newer one is read by a job of its own
    }
    std::shared_ptr<const Result<BodyExtent>> extent;
    try {
        extent = std::make_shared<const Result<BodyExtent>>(extentOfModel(urdf));
    } catch (const std::exception& broken) {  // out of memory
        extent = std::make_shared<const Result<BodyExtent>>(Error{broken.what()});
    }
    const std::lock_guard lock(m_mutex);
    m_topics[topic].extent = std::move(extent);
}

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
                [this](const ReceivedSample& sample) { receive(sample.event); });
            m_subscriptions[topic.name] = subscription ? std::move(subscription).value() : nullptr;
        }
        const auto found = m_topics.find(topic.name);
        if (found != m_topics.end()) topic.model = found->second.extent;
    }
}

}  // namespace leitstand
