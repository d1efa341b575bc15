#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/robot/link/screen_report.h"
#include "core/robot/streams/qos.h"
#include "transport/dds/endpoint.h"
#include "transport/dds/guid.h"
#include "transport/dds/node_settings.h"

namespace leitstand {

/// One sample as it came over the wire.
struct ReceivedSample {
    RawEvent event;   ///< topic, type, bytes as received, time when it was complete here; not yet numbered
    Guid writer;      ///< who wrote it
    Time sourceTime;  ///< when it was written, writer's clock; 0 when unknown
    std::uint64_t writerSequence = 0;  ///< number of the sample at its writer, from 1: gaps are losses
};
using SampleCallback = std::function<void(ReceivedSample)>;

/// Which of a node's two threads calls back: a slow callback in one delays nothing in the other.
enum class Lane : std::uint8_t { Small, Large };

/// What to subscribe to.
struct ReaderSettings {
    std::string topic = {};  ///< ROS name "/kurt3d/odom", or a DDS name without leading slash
    std::string type = {};   ///< ROS name "nav_msgs/msg/Odometry", or a DDS name
    Qos qos = {};            ///< depth: at least 16 are kept between network and callback
    Lane lane = Lane::Small;
};

/// What to publish.
struct WriterSettings {
    std::string topic = {};  ///< as in ReaderSettings
    std::string type = {};
    Qos qos = {};
    Flow flow = Flow::Telemetry;
};

/// What a subscription has received so far.
struct SubscriptionCounts {
    std::uint64_t samples = 0;
    std::uint64_t bytes = 0;
    std::uint64_t lost = 0;  ///< gaps in the writers' numbers
    int writers = 0;         ///< matched now
};

/// Receives samples of a topic until it is destroyed. Once its destructor has returned, its callback no
/// longer runs. A callback may destroy its own subscription, and then runs to its end. Any thread.
class Subscription {
public:
    ~Subscription();
    Subscription(const Subscription&) = delete;
    Subscription& operator=(const Subscription&) = delete;

    [[nodiscard]] SubscriptionCounts counts() const;

private:
    friend class Node;
    struct Impl;
    explicit Subscription(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// A writer on a topic, which others in the domain see until it is destroyed. Any thread.
class Publisher {
public:
    ~Publisher();
    Publisher(const Publisher&) = delete;
    Publisher& operator=(const Publisher&) = delete;

    /// Sends @p cdr, encapsulation header first. Never waits for the network when the history is keep_last.
    /// An error when the bytes are no sample, the node is gone, or a keep_all history stays full for 0.1 s.
    Result<void> write(const Payload& cdr);
    [[nodiscard]] int matched() const;                ///< number of readers that receive what is written
    [[nodiscard]] std::vector<Guid> readers() const;  ///< those readers
    /// Waits; true once all matched reliable readers have everything, false after @p atMost.
    [[nodiscard]] bool waitForAcknowledgments(std::chrono::milliseconds atMost) const;
    [[nodiscard]] Guid guid() const;

private:
    friend class Node;
    struct Impl;
    explicit Publisher(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// A process's place in a DDS domain: one participant over UDP, two threads that call back (docs/design.md,
/// "The wire"). Subscriptions and publishers may outlive it: they then receive and send nothing more. Any
/// thread, but it must not be destroyed by one of its own callbacks.
class Node {
public:
    /// Joins the domain. Errors name the setting: unknown interface, unreadable file, no such domain.
    static Result<std::unique_ptr<Node>> create(const NodeSettings& settings);
    ~Node();
    Node(const Node&) = delete;
    Node& operator=(const Node&) = delete;

    Result<std::unique_ptr<Subscription>> subscribe(const ReaderSettings& settings, SampleCallback callback);
    Result<std::unique_ptr<Publisher>> publisher(const WriterSettings& settings);

    [[nodiscard]] std::vector<RemoteParticipant> participants() const;
    [[nodiscard]] std::vector<RemoteEndpoint> endpoints()
        const;                                               ///< of all topics, also those that are not ROS
    [[nodiscard]] std::vector<Mismatch> mismatches() const;  ///< of our readers and writers with others
    /// Returns what is announced on the topics that we subscribe to, and what of it was received.
    [[nodiscard]] DomainReception reception() const;
    /// Leaves the domain and joins it again as another participant, with another guid(). Subscriptions and
    /// publishers stay, and transient local samples are written again. Samples that are sent meanwhile are
    /// lost. Takes some 0.1 s. Not for callbacks of this node. @p entered receives the new guid() before
    /// anything is sent or received under it. The error names what could not be created again.
    Result<void> rejoin(const std::function<void(const Guid&)>& entered = {});
    /// Calls @p changed once at first and after participants, endpoints, mismatches or drops change, on the
    /// thread of the small lane. Several changes may come as one. Replaces an earlier callback.
    void onDiscovery(std::function<void()> changed);

    /// Returns what the operator should know about this computer; empty when all is well. There may be a
    /// system limit that costs samples, with the command that lifts it. There may be transports that cannot
    /// be screened, or a build of Fast DDS that is not mended (mendsTheLibrary()).
    [[nodiscard]] const std::vector<std::string>& warnings() const;
    /// Returns what the screen kept from the DDS library since the node joined, by reason and sender
    /// (docs/wire.md). Any thread.
    [[nodiscard]] std::vector<ScreenDrop> dropped() const;
    [[nodiscard]] Guid guid() const;

private:
    struct Impl;
    explicit Node(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand
