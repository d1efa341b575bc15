#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/event/sample_header.h"
#include "core/messages/message_text.h"

namespace leitstand {

/// Numbers of a message, and its header if its first field is a std_msgs/Header.
struct FieldNumbers {
    SampleHeader header;
    std::vector<double> values;  ///< Unknown where an array of the message is too short
};

/// Returns the numbers at @p paths (ReadingDescription::field) in @p message, which is XCDR1 with its
/// encapsulation header and of the type @p text. Errors: a path that leads to no number, a message of another
/// layout.
[[nodiscard]] Result<FieldNumbers> numbersAt(const MessageText& text, std::span<const std::string> paths,
                                             std::span<const std::byte> message);

/// Returns a message of the type @p text with @p numbers at @p paths. Everything else is 0 or empty. Errors:
/// a path to no number or into an array whose length the type leaves open.
[[nodiscard]] Result<Payload> messageWith(const MessageText& text, std::span<const std::string> paths,
                                          const FieldNumbers& numbers);

/// Error: one of @p paths leads to no number in messages of the type @p text. It tells what is there.
[[nodiscard]] Result<void> checkPaths(const MessageText& text, std::span<const std::string> paths);

/// Returns the text of the ROS type @p type, parsed once; null: the type is not known. Any thread.
[[nodiscard]] const MessageText* knownText(std::string_view type);

}  // namespace leitstand
