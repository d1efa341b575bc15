#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// A field in the text of a message type.
struct MessageField {
    std::string type;  ///< "float64", "string", "geometry_msgs/Point"; without array and bounds
    std::string name;
    bool array = false;                  ///< of any length; with count: of this length
    std::optional<std::uint32_t> count;  ///< empty: the message holds the length
    friend bool operator==(const MessageField&, const MessageField&) = default;
};
using MessageFields = std::vector<MessageField>;

/// The fields of a message type and of all types in it, by the text that bags hold of it. That is its .msg
/// file, then those of the types that it uses, behind lines of = (rosbag2's "ros2msg"; bags of ROS 1 hold the
/// same). Bounds, defaults and constants are left out.
class MessageText {
public:
    static constexpr int Deepest = 32;  ///< types within types
    static constexpr std::size_t Longest = 1U << 20U;

    /// Parses @p definition of @p type ("sensor_msgs/msg/LaserScan", or as ROS 1 names it,
    /// "sensor_msgs/LaserScan"). Errors: its length, a line, a type that is missing, types in a circle.
    [[nodiscard]] static Result<MessageText> parse(const std::string& type, std::string_view definition);

    /// Its name without "/msg": "sensor_msgs/LaserScan".
    [[nodiscard]] const std::string& type() const { return m_type; }
    [[nodiscard]] const MessageFields& fields() const { return m_types.at(m_type); }
    /// Fields of @p type, a MessageField::type of these; null: it is a number or text.
    [[nodiscard]] const MessageFields* fieldsOf(const std::string& type) const;
    [[nodiscard]] const std::map<std::string, MessageFields>& types() const { return m_types; }

private:
    [[nodiscard]] Result<void> check() const;

    std::string m_type;
    std::map<std::string, MessageFields> m_types;
};

/// Returns how many bytes a number of @p type has on the wire; 0: it is no number ("string", "time", a type).
[[nodiscard]] std::size_t sizeOfNumber(std::string_view type);
/// Whether @p type is a text: "string" or "wstring".
[[nodiscard]] bool isTextType(std::string_view type);

}  // namespace leitstand
