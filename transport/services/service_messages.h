#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/robot/services/service_description.h"

namespace leitstand {

/// Names of the DDS topics of a ROS 2 service: requests are written on the first, answers on the second
/// (design.ros2.org, "Topic and Service name mapping to DDS").
struct ServiceTopics {
    std::string request, answer;          ///< "rq/e_stopRequest", "rr/e_stopReply"
    std::string requestType, answerType;  ///< "std_srvs/srv/SetBool_Request"
};
/// @p name: ROS name, "/e_stop"; @p type: ROS name, "std_srvs/srv/SetBool".
[[nodiscard]] ServiceTopics topicsOf(const std::string& name, const std::string& type);
/// The ROS name of the service whose requests are on @p ddsTopic; empty: it is no such topic.
[[nodiscard]] std::string serviceOf(const std::string& ddsTopic);
/// The ROS type of the service whose requests have @p rosType; empty: it is no such type.
[[nodiscard]] std::string serviceTypeOf(const std::string& rosType);

/// A request or answer as bytes in XCDR1, with its encapsulation header.
[[nodiscard]] Payload encodeRequest(ServiceKind kind, const ServiceRequest& request);
[[nodiscard]] Payload encodeAnswer(ServiceKind kind, const ServiceAnswer& answer);
/// Errors tell which field does not fit. Texts are cut to 200 bytes and made printable.
[[nodiscard]] Result<ServiceRequest> decodeRequest(ServiceKind kind, std::span<const std::byte> bytes);
[[nodiscard]] Result<ServiceAnswer> decodeAnswer(ServiceKind kind, std::span<const std::byte> bytes);

/// Identifies a call within a request or answer of rmw_cyclonedds: 16 bytes before the fields.
struct CallHeader {
    std::uint64_t client = 0;  ///< chosen by the client
    std::int64_t number = 0;
    friend bool operator==(const CallHeader&, const CallHeader&) = default;
};
/// Puts @p header between the encapsulation of @p body and its fields.
[[nodiscard]] Payload withHeader(const CallHeader& header, const Payload& body);
struct HeadedBody {
    CallHeader header;
    Payload body;
};
/// Takes the header out of @p bytes; empty: they are too short.
[[nodiscard]] std::optional<HeadedBody> splitHeader(std::span<const std::byte> bytes);

}  // namespace leitstand
