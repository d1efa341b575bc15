#include "transport/dds/ros_presence.h"

#include <chrono>
#include <utility>
#include <vector>

namespace leitstand {
namespace {

constexpr std::chrono::seconds Period(1);

WriterSettings announcing() {
    WriterSettings settings;
    settings.topic = RosDiscoveryTopic;
    settings.type = RosDiscoveryType;
    settings.qos.reliability = Qos::Reliability::Reliable;
    settings.qos.durability = Qos::Durability::TransientLocal;
    settings.qos.depth = 1;
    return settings;
}

}  // namespace

RosPresence::RosPresence(Node& node, const RosNodes& others, std::string name)
    : m_node(node),
      m_others(others),
      m_name(std::move(name)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

void RosPresence::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        look();
        std::unique_lock lock(m_mutex);
        m_wake.wait_for(lock, stop, Period, [] { return false; });
    }
}

void RosPresence::look() {
    std::vector<Guid> participants;
    for (const RemoteParticipant& one : m_node.participants()) participants.push_back(one.guid);
    // Others of the same name go by what they hear, too: they would keep each other's size for ever.
    const auto size = m_others.gidSize(participants, m_name);
    if (!size) {
        m_publisher.reset();
        m_size = 0;
        return;
    }
    const Guid me = m_node.guid();
    Node::OwnEndpoints own = m_node.ownEndpoints();
    if (m_publisher && *size == m_size && me == m_me && own == m_announced) return;
    // Nobody may hear an announcement in the size of before from a history.
    if (*size != m_size) m_publisher.reset();
    if (!m_publisher) {
        auto made = m_node.publisher(announcing());
        if (!made) return;  // without permission: others do not list this process
        m_publisher = std::move(made).value();
    }
    const RosProcess process{me, *size, {{m_name, own.readers, own.writers}}};
    if (!m_publisher->write(rosAnnouncement(process))) return;
    m_size = *size;
    m_me = me;
    m_announced = std::move(own);
}

}  // namespace leitstand
