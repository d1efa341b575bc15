#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/messages/message_text.h"

namespace leitstand::detail {

/// A ROS 1 message type, by the text that a bag holds of it, and how its messages become those of ROS 2. ROS
/// 1 puts fields one behind the other; CDR aligns them and ends strings with a zero. Fields that only one of
/// both has are left out or filled: `seq` of a header is left out, BatteryState gets a temperature, which is
/// unknown.
class Ros1Layout {
public:
    /// Parses @p definition of @p type ("sensor_msgs/LaserScan"): its fields, and behind lines of = the types
    /// that it uses. Error: a line, or a type that is missing.
    [[nodiscard]] static Result<Ros1Layout> parse(const std::string& type, std::string_view definition);

    /// Returns @p message as CDR, little-endian, with its encapsulation header. Empty: the message does not
    /// have this layout, or its CDR would be longer than @p most bytes.
    [[nodiscard]] std::optional<std::vector<std::byte>> cdrOf(std::span<const std::byte> message,
                                                              std::size_t most) const;

private:
    enum class Kind : std::uint8_t { Number, Text, Moment, Type };
    struct Field {
        Kind kind = Kind::Number;
        std::size_t size = 0;  ///< of a number [B]
        std::string type;      ///< of Kind::Type, "geometry_msgs/Point"
        bool array = false;    ///< of any length; with count: of this length
        std::optional<std::uint32_t> count;
        bool added = false;    ///< ROS 2 alone has it: a float32, NaN
        bool leftOut = false;  ///< ROS 1 alone has it
    };
    using Fields = std::vector<Field>;
    class Writing;

    [[nodiscard]] static Field fieldOf(const MessageField& said);

    std::string m_type;
    std::map<std::string, Fields> m_types;
};

/// Returns the ROS 2 name of the ROS 1 type @p type: "sensor_msgs/msg/LaserScan" of "sensor_msgs/LaserScan".
[[nodiscard]] std::string ros2TypeOf(const std::string& type);

}  // namespace leitstand::detail
