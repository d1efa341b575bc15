#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Which service a client calls.
struct ClientSettings {
    std::string name = {};  ///< ROS name, "/e_stop"
    std::string type = {};  ///< ROS name, "std_srvs/srv/SetBool"
    /// A request that is not delivered within this time is dropped; 0: never.
    std::chrono::milliseconds lifespan{0};
};

/// Calls a ROS 2 service of another process. It speaks to servers on Fast DDS (rmw_fastrtps: the inline QoS
/// of an answer names the request) and on Cyclone DDS (rmw_cyclonedds: a header in the payload names the
/// call). Which one is meant is in the server's GUID, whose first two bytes tell the vendor. Any thread.
class ServiceClient {
public:
    /// Called with the tag of a call and its answer in XCDR1, at most once for each call, on the node's
    /// thread for small samples. It must not destroy the client.
    using Answered = std::function<void(std::uint64_t tag, const Payload& answer)>;

    /// @p answered may be empty. Errors name the topic that the node may not use.
    [[nodiscard]] static Result<std::unique_ptr<ServiceClient>> create(Node& node,
                                                                       const ClientSettings& settings,
                                                                       Answered answered);
    ~ServiceClient();
    ServiceClient(const ServiceClient&) = delete;
    ServiceClient& operator=(const ServiceClient&) = delete;

    /// The servers that would hear a call now, and whose answers would be heard.
    [[nodiscard]] std::vector<Guid> servers() const;
    /// Sends @p request; its answer comes with @p tag, which the caller chooses. Never waits. A server that
    /// has not found this client yet misses the call without a word. Errors: nobody serves, or servers of
    /// both kinds do, so that one of them would take the call for something else.
    Result<void> call(const Payload& request, std::uint64_t tag);

private:
    struct State;
    explicit ServiceClient(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
