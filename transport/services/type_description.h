#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/messages/message_text.h"

namespace leitstand {

// Nodes of ROS 2 Iron and later tell what the types are made of that they use (REP 2016): a service of each
// node, NODE/get_type_description. Bytes are in XCDR1, with their encapsulation header.

inline constexpr const char* TypeDescriptionService = "type_description_interfaces/srv/GetTypeDescription";

/// Which type is asked for.
struct TypeRequest {
    std::string type;  ///< "nav_msgs/msg/Odometry"
    std::string hash;  ///< "RIHS01_..."
};
[[nodiscard]] Payload encodeTypeRequest(const TypeRequest& request);
[[nodiscard]] Result<TypeRequest> decodeTypeRequest(std::span<const std::byte> bytes);

/// Returns what a node answers that knows @p text. @p reason: why it knows none; empty: it does.
[[nodiscard]] Payload encodeTypeAnswer(const MessageText& text, const std::string& reason = {});
/// Returns the type in the answer to a request for @p type. Any bytes are safe. Errors: the node's own
/// reason, another type than was asked for, or a layout that the station does not read (wide characters).
[[nodiscard]] Result<MessageText> decodeTypeAnswer(std::span<const std::byte> bytes, const std::string& type);

}  // namespace leitstand
