#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/messages/message_text.h"

namespace leitstand {

/// A field of a received message, for people.
struct InspectedField {
    std::string path;   ///< "pose.position.x", "ranges", "points[3].x"
    std::string value;  ///< "1.5", "\"base_link\"", "360 numbers, 0.12 to 30"; empty: its fields follow
    int depth = 0;      ///< types that it is in
    std::optional<double> number;  ///< of a number or bool
    friend bool operator==(const InspectedField&, const InspectedField&) = default;
};

/// A message as rows, in the order of its type.
struct InspectedMessage {
    static constexpr std::size_t MostFields = 1000;
    /// Elements of longer arrays of numbers have no rows of their own.
    static constexpr std::size_t MostElements = 16;

    std::vector<InspectedField> fields;
    bool cut = false;  ///< there were more than MostFields, or a text of a kind that is not read (wstring)
};

/// Reads @p message (XCDR1 with its encapsulation header) by the text of its type. Error: it does not have
/// this layout.
[[nodiscard]] Result<InspectedMessage> inspect(const MessageText& text, std::span<const std::byte> message);

/// Returns the number in the field at @p path; empty: there is none.
[[nodiscard]] std::optional<double> numberAt(const InspectedMessage& message, const std::string& path);

}  // namespace leitstand
