#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
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

/// A sample as it was received.
struct ReceivedSample {
    RawEvent event;   ///< topic, type, bytes as received, and when it was complete; it has no sequence yet
    Guid writer;      ///< who wrote it
    Time sourceTime;  ///< when it was written, writer's clock; 0 when unknown
    std::uint64_t writerSequence = 0;  ///< the writer's number for the sample, from 1; gaps are losses
    /// The other sample that this one names in its inline QoS, if any: an answer names its request.
    std::optional<SampleIdentity> related = {};
};
using SampleCallback = std::function<void(ReceivedSample)>;

/// Which of a node's two threads calls back. A slow callback in one thread does not delay the other.
enum class Lane : std::uint8_t { Small, Large };

/// What to subscribe to.
struct ReaderSettings {
    std::string topic = {};  ///< ROS name "/kurt3d/odom", or a DDS name without leading slash
    std::string type = {};   ///< ROS name "nav_msgs/msg/Odometry", or a DDS name
    Qos qos = {};            ///< depth: at least 16 samples are kept between network and callback
    Lane lane = Lane::Small;
};

/// What to publish.
struct WriterSettings {
    std::string topic = {};  ///< as in ReaderSettings
    std::string type = {};
    Qos qos = {};
    Flow flow = Flow::Telemetry;
    /// Announced as the hash of the type, "RIHS01_..."; empty: that of a type that is built in, if it is one.
    std::string typeHash = {};
};

/// What a subscription has received so far.
struct SubscriptionCounts {
    std::uint64_t samples = 0;
    std::uint64_t bytes = 0;
    std::uint64_t lost = 0;  ///< gaps in the writers' numbers
    int writers = 0;         ///< matched now
};

/// Receives samples of a topic until it is destroyed. When its destructor has returned, its callback no
/// longer runs. A callback may destroy its own subscription, and then runs to its end. Any thread.
class Subscription {
public:
    ~Subscription();
    Subscription(const Subscription&) = delete;
    Subscription& operator=(const Subscription&) = delete;

    [[nodiscard]] SubscriptionCounts counts() const;
    [[nodiscard]] std::vector<Guid> writers() const;  ///< identities of the matched writers
    [[nodiscard]] Guid guid() const;

private:
    friend class Node;
    struct Impl;
    explicit Subscription(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// A writer on a topic. Others in the domain see it until it is destroyed. Any thread.
class Publisher {
public:
    ~Publisher();
    Publisher(const Publisher&) = delete;
    Publisher& operator=(const Publisher&) = delete;

    /// Sends @p cdr, which begins with the encapsulation header. Never waits for the network if the history
    /// is keep_last. Error: the bytes are no sample, the node is gone, or a keep_all history stays full for
    /// 0.1 s.
    Result<void> write(const Payload& cdr);
    /// Writes @p cdr as write() does, with @p related in its inline QoS; a number of 0 is unknown. Returns
    /// the writer's number for the sample. Fails also while the node joins its domain again.
    Result<std::uint64_t> write(const Payload& cdr, const SampleIdentity& related);
    [[nodiscard]] int matched() const;                ///< number of readers that receive what is written
    [[nodiscard]] std::vector<Guid> readers() const;  ///< identities of those readers
    /// Waits until all matched reliable readers have received everything. Returns false if that takes longer
    /// than @p atMost.
    [[nodiscard]] bool waitForAcknowledgments(std::chrono::milliseconds atMost) const;
    [[nodiscard]] Guid guid() const;

private:
    friend class Node;
    struct Impl;
    explicit Publisher(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// A process's membership in a DDS domain: one participant over UDP, and two threads that call back
/// (docs/design.md, "The wire"). Subscriptions and publishers may outlive it; then they receive and send
/// nothing more. Any thread, but its own callbacks must not destroy it.
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
        const;  ///< on all topics, including those that do not belong to ROS
    /// Our own readers and writers whose names are those of ROS: topics, services and actions.
    struct OwnEndpoints {
        std::vector<Guid> readers, writers;  ///< sorted
        friend bool operator==(const OwnEndpoints&, const OwnEndpoints&) = default;
    };
    [[nodiscard]] OwnEndpoints ownEndpoints() const;
    [[nodiscard]] std::vector<Mismatch> mismatches() const;  ///< between our readers or writers and others
    /// Returns what is announced on the topics to which we subscribe, and from which writers samples were
    /// received.
    [[nodiscard]] DomainReception reception() const;
    /// Leaves the domain and joins it again as another participant, with another guid(). Subscriptions and
    /// publishers remain, and transient local samples are written again. Samples that are sent in between are
    /// lost. Takes some 0.1 s. Must not be called from callbacks of this node. @p entered receives the new
    /// guid() before anything is sent or received with it. The error says what could not be created again.
    Result<void> rejoin(const std::function<void(const Guid&)>& entered = {});
    /// Calls @p changed once at first, and after participants, endpoints, mismatches or drops change, on the
    /// thread of the small lane. One call may stand for several changes. Replaces an earlier callback.
    void onDiscovery(std::function<void()> changed);

    /// Returns what the operator should know about this computer; empty: nothing. These are system limits
    /// that cause losses (with the command that raises them), and transports that cannot be screened. A build
    /// of Fast DDS whose defects are not worked around is also included (mendsTheLibrary()).
    [[nodiscard]] const std::vector<std::string>& warnings() const;
    /// Returns the datagrams that the screen did not pass to the DDS library since the node joined, by reason
    /// and sender (docs/wire.md). Any thread.
    [[nodiscard]] std::vector<ScreenDrop> dropped() const;
    [[nodiscard]] Guid guid() const;

private:
    struct Impl;
    explicit Node(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand
