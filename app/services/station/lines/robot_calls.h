#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Whether @p service is called when the operator wants it: it switches or triggers something, and has no
/// part in a stop.
[[nodiscard]] bool isOperators(const ServiceDescription& service);

/// Calls those services of one robot that have no part in its stop, when the operator wants it. Any thread;
/// nothing waits for the network.
class RobotCalls {
public:
    struct Outcome {
        ServiceDescription service;
        bool value = false;                   ///< what a Switch was set to
        std::optional<ServiceAnswer> answer;  ///< empty: nobody answered within 3 s
    };
    /// Called once for each call, on the node's thread or on that of expire(). It must not destroy the
    /// object.
    using Ended = std::function<void(const Outcome&)>;

    /// Services that the node may not use, as without permission, are left out; @p problems says which and
    /// why.
    [[nodiscard]] static std::unique_ptr<RobotCalls> create(Node& node, const RobotDescription& robot,
                                                            Ended ended, std::vector<std::string>& problems);
    ~RobotCalls();
    RobotCalls(const RobotCalls&) = delete;
    RobotCalls& operator=(const RobotCalls&) = delete;

    /// Calls the service with the ROS name @p service. Errors: the robot's file names none such, or nobody
    /// offers it.
    Result<void> call(const std::string& service, bool value);
    /// Whether anybody offers @p service.
    [[nodiscard]] bool isOffered(const std::string& service) const;
    /// Ends calls that were not answered in time. Call a few times a second.
    void expire(SteadyTime now);

private:
    struct State;
    explicit RobotCalls(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

/// What became of a call, in the operator's language: "Lamp on: done".
[[nodiscard]] std::string worded(const RobotCalls::Outcome& outcome);

}  // namespace leitstand
