#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/robot/services/service_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Offers a ROS 2 service as rmw_fastrtps does. For robots; a station only calls. Any thread.
class ServiceServer {
public:
    /// Answers a request, on the node's thread for small samples. Empty: no answer, as of a node that hangs.
    using Serve = std::function<std::optional<ServiceAnswer>(const ServiceRequest&)>;
    using ServeRaw = std::function<Payload(const Payload& request)>;  ///< the same in XCDR1; null: no answer

    /// @p name: ROS name, "/e_stop"; @p type: a type of serviceTable(). Errors: another type, or a topic that
    /// the node may not use.
    [[nodiscard]] static Result<std::unique_ptr<ServiceServer>> create(Node& node, const std::string& name,
                                                                       const std::string& type, Serve serve);
    /// As create(), for any type.
    [[nodiscard]] static Result<std::unique_ptr<ServiceServer>> createRaw(Node& node, const std::string& name,
                                                                          const std::string& type,
                                                                          ServeRaw serve);
    ~ServiceServer();
    ServiceServer(const ServiceServer&) = delete;
    ServiceServer& operator=(const ServiceServer&) = delete;

private:
    struct State;
    explicit ServiceServer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
