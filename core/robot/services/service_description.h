#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leitstand {

/// What a service is asked and answers.
enum class ServiceKind : std::uint8_t {
    Switch,      ///< sets a flag; answers success and a message (std_srvs/srv/SetBool)
    Trigger,     ///< is asked nothing; answers as Switch does (std_srvs/srv/Trigger)
    CancelGoal,  ///< cancels all goals of an action (action_msgs/srv/CancelGoal)
    /// An action that drives the robot to a place (nav2_msgs/action/NavigateToPose). A stop cancels its
    /// goals, unless ServiceDescription::stop is false.
    Navigate,
};

/// A type of services that the station can call.
struct ServiceFacts {
    std::string_view type;  ///< ROS name, "std_srvs/srv/SetBool"
    ServiceKind kind{};
};

/// All types of services that the station can call.
[[nodiscard]] std::span<const ServiceFacts> serviceTable();
/// Null: the station cannot call services of @p type.
[[nodiscard]] const ServiceFacts* serviceFacts(std::string_view type);

/// A service of a robot that the station calls.
struct ServiceDescription {
    std::string name = {};   ///< ROS name, "/e_stop"
    std::string type = {};   ///< a type of serviceTable()
    std::string title = {};  ///< for the operator; empty: `name`
    /// Its part in a STOP; empty: none. A Switch is set to this value by a stop, and to the other value by
    /// the release. A Trigger is called by a stop (true) or by the release (false). Of an action, the goals
    /// are cancelled by a stop (true).
    std::optional<bool> stop = {};
    friend bool operator==(const ServiceDescription&, const ServiceDescription&) = default;
};

/// What one part of a STOP asks of a service.
struct ServiceRequest {
    bool value = false;  ///< of a Switch
    friend bool operator==(const ServiceRequest&, const ServiceRequest&) = default;
};

/// What a service answered.
struct ServiceAnswer {
    bool accepted = false;     ///< whether it did what it was asked
    std::string message = {};  ///< its own words; may be empty
    friend bool operator==(const ServiceAnswer&, const ServiceAnswer&) = default;
};

/// What is asked of @p service when the robot is stopped; empty: nothing.
[[nodiscard]] std::optional<ServiceRequest> stopRequest(const ServiceDescription& service);
/// What is asked of @p service when the robot is released; empty: nothing.
[[nodiscard]] std::optional<ServiceRequest> releaseRequest(const ServiceDescription& service);

}  // namespace leitstand
