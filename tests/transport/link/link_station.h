#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "tests/transport/dds/test_node.h"
#include "transport/link/link_client.h"

namespace leitstand::test {

/// A station as its session has it: subscribes to what the robot says and hands it to the link's client.
class LinkStation {
public:
    LinkStation(Node& node, const RobotDescription& robot, const std::string& name = "station one") {
        LinkClientSettings settings;
        settings.station = name;
        LinkListener listener;
        listener.onState = [this](const LinkStatus& link) {
            const std::scoped_lock lock(m_mutex);
            m_states.push_back(link.state);
        };
        listener.onStatus = [this](const LinkStatus& link) {
            const std::scoped_lock lock(m_mutex);
            m_reported = link;
        };
        listener.onClockOffset = [this](const ClockOffsetSample& sample) {
            const std::scoped_lock lock(m_mutex);
            m_offsets.push_back(sample);
        };
        listener.onPing = [this](const RawEvent& event) {
            const std::scoped_lock lock(m_mutex);
            m_pings.push_back(event);
        };
        listener.onPong = [this](const ReceivedSample& sample) {
            const std::scoped_lock lock(m_mutex);
            m_pongs.push_back(sample.event);
        };
        m_client = must(LinkClient::create(node, robot, settings, std::move(listener)));
        for (const StreamDescription& stream : robot.streams) {
            if (isCommand(stream.role)) continue;
            m_subscriptions.push_back(
                must(node.subscribe({stream.topic, stream.type, stream.qos, Lane::Small},
                                    [this](const ReceivedSample& sample) { m_client->onSample(sample); })));
        }
    }
    ~LinkStation() { m_subscriptions.clear(); }
    LinkStation(const LinkStation&) = delete;
    LinkStation& operator=(const LinkStation&) = delete;

    [[nodiscard]] LinkClient& client() { return *m_client; }
    [[nodiscard]] LinkStatus status() const { return m_client->status(); }
    /// Waits until the client says so.
    [[nodiscard]] bool becomes(LinkState state,
                               std::chrono::seconds atMost = std::chrono::seconds(30)) const {
        return waitUntil([&] { return reported().state == state; }, atMost);
    }
    /// Waits until the robot is connected and has answered pings.
    [[nodiscard]] bool hearsPongs(std::size_t atLeast) const {
        return becomes(LinkState::Connected) && waitUntil([&] { return pongs().size() >= atLeast; });
    }
    [[nodiscard]] std::vector<LinkState> states() const { return copyOf(m_states); }
    [[nodiscard]] LinkStatus reported() const { return copyOf(m_reported); }
    [[nodiscard]] std::vector<ClockOffsetSample> offsets() const { return copyOf(m_offsets); }
    [[nodiscard]] std::vector<RawEvent> pings() const { return copyOf(m_pings); }
    [[nodiscard]] std::vector<RawEvent> pongs() const { return copyOf(m_pongs); }

private:
    template <class T>
    [[nodiscard]] T copyOf(const T& value) const {
        const std::scoped_lock lock(m_mutex);
        return value;
    }
    mutable std::mutex m_mutex;
    std::vector<LinkState> m_states;
    LinkStatus m_reported;
    std::vector<ClockOffsetSample> m_offsets;
    std::vector<RawEvent> m_pings, m_pongs;
    std::unique_ptr<LinkClient> m_client;
    std::vector<std::unique_ptr<Subscription>> m_subscriptions;
};

}  // namespace leitstand::test
