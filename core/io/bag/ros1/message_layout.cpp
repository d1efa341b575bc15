#include "core/io/bag/ros1/message_layout.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

namespace leitstand::detail {
namespace {

constexpr std::size_t FreeSteps = 100'000;  ///< fields of a message, and four for each of its bytes

}  // namespace

std::string ros2TypeOf(const std::string& type) {
    if (type == "tf/tfMessage") return "tf2_msgs/msg/TFMessage";
    const auto slash = type.find('/');
    return slash == std::string::npos ? type : type.substr(0, slash) + "/msg" + type.substr(slash);
}

Ros1Layout::Field Ros1Layout::fieldOf(const MessageField& said) {
    Field field;
    field.array = said.array;
    field.count = said.count;
    if (field.size = sizeOfNumber(said.type); field.size > 0) return field;
    if (isTextType(said.type)) {
        field.kind = Kind::Text;
    } else if (said.type == "time" || said.type == "duration") {
        field.kind = Kind::Moment;
    } else {
        field.kind = Kind::Type;
        field.type = said.type;
    }
    return field;
}

Result<Ros1Layout> Ros1Layout::parse(const std::string& type, std::string_view definition) {
    const auto text = MessageText::parse(type, definition);
    if (!text) return text.error();
    Ros1Layout layout;
    layout.m_type = text->type();
    for (const auto& [name, fields] : text->types()) {
        Fields& its = layout.m_types[name];
        for (const MessageField& one : fields) {
            its.push_back(fieldOf(one));
            its.back().leftOut = name == "std_msgs/Header" && one.name == "seq";
            if (name == "sensor_msgs/BatteryState" && one.name == "voltage") {
                Field temperature;
                temperature.size = 4;
                temperature.added = true;
                its.push_back(temperature);
            }
        }
    }
    return layout;
}

/// Turns one message.
class Ros1Layout::Writing {
public:
    Writing(const Ros1Layout& layout, std::span<const std::byte> message, std::size_t most)
        : m_layout(layout), m_left(message), m_most(most), m_steps(FreeSteps + 4 * message.size()) {
        for (const int one : {0, 1, 0, 0})
            m_out.push_back(static_cast<std::byte>(one));  // CDR, little-endian
    }

    void fields(const std::string& type) {
        m_ok = m_ok && ++m_depth <= MessageText::Deepest;
        if (!m_ok) return;
        const Fields& all = m_layout.m_types.at(type);
        const bool nothing =
            std::all_of(all.begin(), all.end(), [](const Field& one) { return one.leftOut; });
        if (nothing) put({std::byte{0}}, 1);  // ROS 2 wants a member, and adds one
        for (const Field& field : all) {
            if (!m_ok) return;
            one(field);
        }
        --m_depth;
    }
    [[nodiscard]] bool whole() const { return m_ok && m_left.empty(); }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(m_out); }

private:
    void one(const Field& field) {
        // Types that hold nothing but others could take for ever.
        m_ok = m_ok && m_steps > 0;
        m_steps -= m_ok ? 1 : 0;
        if (!m_ok) return;
        if (field.added) {
            const float unknown = std::numeric_limits<float>::quiet_NaN();
            std::array<std::byte, 4> bytes{};
            std::memcpy(bytes.data(), &unknown, bytes.size());
            return put(bytes, 4);
        }
        if (!field.array) return element(field);
        std::uint32_t count = field.count.value_or(0);
        if (!field.count) {
            count = length();
            if (!field.leftOut) put(bytesOf(count), 4);
        }
        if (field.kind == Kind::Number) {
            const auto bytes = read(std::uint64_t{count} * field.size);
            if (!field.leftOut && count > 0) put(bytes, field.size);
            return;
        }
        // Elements of no bytes would let a short message claim any number.
        if (count > m_left.size() + 1) m_ok = false;
        for (std::uint32_t i = 0; i < count && m_ok; ++i) element(field);
    }
    void element(const Field& field) {
        switch (field.kind) {
            case Kind::Number: {
                const auto bytes = read(field.size);
                if (!field.leftOut) put(bytes, field.size);
                return;
            }
            case Kind::Moment: {
                const auto seconds = read(4), nanoseconds = read(4);
                put(seconds, 4);
                return put(nanoseconds, 4);
            }
            case Kind::Text: {
                const std::uint32_t size = length();
                const auto letters = read(size);
                put(bytesOf(size + 1), 4);
                put(letters, 1);
                return put({std::byte{0}}, 1);
            }
            case Kind::Type:
                return fields(field.type);
        }
    }
    [[nodiscard]] static std::array<std::byte, 4> bytesOf(std::uint32_t number) {
        std::array<std::byte, 4> bytes{};
        for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<std::byte>(number >> (8 * i));
        return bytes;
    }
    [[nodiscard]] std::uint32_t length() {
        std::uint32_t number = 0;
        const auto bytes = read(4);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            number |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
        return number;
    }
    [[nodiscard]] std::span<const std::byte> read(std::uint64_t size) {
        if (!m_ok || size > m_left.size()) {
            m_ok = false;
            return {};
        }
        const auto bytes = m_left.first(static_cast<std::size_t>(size));
        m_left = m_left.subspan(static_cast<std::size_t>(size));
        return bytes;
    }
    void put(std::initializer_list<std::byte> bytes, std::size_t alignment) {
        put(std::span(bytes.begin(), bytes.size()), alignment);
    }
    void put(std::span<const std::byte> bytes, std::size_t alignment) {
        constexpr std::size_t Head = 4;  // CDR aligns behind its encapsulation header
        if (m_ok && !bytes.empty())
            while ((m_out.size() - Head) % alignment != 0) m_out.push_back(std::byte{0});
        if (!m_ok || bytes.size() > m_most - std::min(m_most, m_out.size())) {
            m_ok = m_ok && bytes.empty();
            return;
        }
        m_out.insert(m_out.end(), bytes.begin(), bytes.end());
    }

    const Ros1Layout& m_layout;
    std::span<const std::byte> m_left;
    const std::size_t m_most;
    std::size_t m_steps;  ///< fields that it may take
    int m_depth = 0;      ///< types within types
    std::vector<std::byte> m_out;
    bool m_ok = true;
};

std::optional<std::vector<std::byte>> Ros1Layout::cdrOf(std::span<const std::byte> message,
                                                        std::size_t most) const {
    Writing writing(*this, message, most);
    writing.fields(m_type);
    return writing.whole() ? std::optional(writing.take()) : std::nullopt;
}

}  // namespace leitstand::detail
