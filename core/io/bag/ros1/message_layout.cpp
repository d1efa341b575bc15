#include "core/io/bag/ros1/message_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <limits>
#include <set>
#include <utility>

#include "core/base/words.h"

namespace leitstand::detail {
namespace {

constexpr int Deepest = 32;  ///< types within types
constexpr std::size_t LongestText = 1U << 20U;
constexpr std::size_t FreeSteps = 100'000;  ///< fields of a message, and four for each of its bytes
constexpr auto Numbers = std::to_array<std::pair<std::string_view, std::size_t>>({
    {"bool", 1},
    {"int8", 1},
    {"uint8", 1},
    {"byte", 1},
    {"char", 1},
    {"int16", 2},
    {"uint16", 2},
    {"int32", 4},
    {"uint32", 4},
    {"float32", 4},
    {"int64", 8},
    {"uint64", 8},
    {"float64", 8},
});

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Returns the lines of @p text one after the other.
template <class Take>
void forEachLine(std::string_view text, Take take) {
    while (!text.empty()) {
        const auto end = text.find('\n');
        take(trimmed(text.substr(0, end)));
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
}

std::string packageOf(const std::string& type) {
    return type.substr(0, type.find('/'));
}

}  // namespace

std::string ros2TypeOf(const std::string& type) {
    if (type == "tf/tfMessage") return "tf2_msgs/msg/TFMessage";
    const auto slash = type.find('/');
    return slash == std::string::npos ? type : type.substr(0, slash) + "/msg" + type.substr(slash);
}

Result<Ros1Layout::Field> Ros1Layout::fieldOf(const std::string& word, const std::string& package) {
    Field field;
    std::string name = word;
    if (const auto bracket = name.find('['); bracket != std::string::npos) {
        field.array = true;
        const std::string_view count = std::string_view(name).substr(bracket + 1);
        std::uint32_t number = 0;
        const auto read = std::from_chars(count.data(), count.data() + count.size(), number);
        if (read.ptr != count.data()) field.count = number;
        if (std::string_view(read.ptr, static_cast<std::size_t>(count.data() + count.size() - read.ptr)) !=
            "]")
            return Error{leitstand::fill(translate("leitstand::Error", "expected a type, found \"{}\""),
                                         word.substr(0, 80))};
        name.resize(bracket);
    }
    const auto* const known =
        std::find_if(Numbers.begin(), Numbers.end(), [&](const auto& one) { return one.first == name; });
    if (known != Numbers.end()) {
        field.size = known->second;
    } else if (name == "string") {
        field.kind = Kind::Text;
    } else if (name == "time" || name == "duration") {
        field.kind = Kind::Moment;
    } else {
        field.kind = Kind::Type;
        field.type = name == "Header"                      ? "std_msgs/Header"
                     : name.find('/') == std::string::npos ? package + "/" + name
                                                           : name;
    }
    return field;
}

Result<Ros1Layout> Ros1Layout::parse(const std::string& type, std::string_view definition) {
    if (definition.size() > LongestText)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected a text of at most {} bytes"),
                                     type, LongestText)};
    Ros1Layout layout;
    layout.m_type = type;
    std::string current = type;
    layout.m_types[current];
    std::optional<Error> problem;
    forEachLine(definition, [&](std::string_view line) {
        if (problem || line.starts_with("===")) return;
        if (line.starts_with("MSG:")) {
            current = std::string(trimmed(line.substr(4)));
            layout.m_types[current].clear();
            return;
        }
        line = trimmed(line.substr(0, line.find('#')));
        const auto space = line.find_first_of(" \t");
        if (line.empty() || space == std::string_view::npos) return;
        const std::string word(line.substr(0, space));
        const std::string_view name = trimmed(line.substr(space));
        if (name.find('=') != std::string_view::npos) return;  // a constant
        auto field = fieldOf(word, packageOf(current));
        if (!field) {
            problem = Error{current + ": " + field.error().text};
            return;
        }
        Field made = std::move(field).value();
        made.leftOut = current == "std_msgs/Header" && name == "seq";
        layout.m_types[current].push_back(std::move(made));
        if (current == "sensor_msgs/BatteryState" && name == "voltage") {
            Field temperature;
            temperature.size = 4;
            temperature.added = true;
            layout.m_types[current].push_back(temperature);
        }
    });
    if (problem) return *problem;
    std::set<std::string> checked;
    if (const auto whole = layout.check(type, 0, checked); !whole) return whole.error();
    return layout;
}

Result<void> Ros1Layout::check(const std::string& type, int depth, std::set<std::string>& checked) const {
    const auto fields = m_types.find(type);
    if (fields == m_types.end() || depth > Deepest)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: its text lacks the type {}"), m_type,
                                     type.substr(0, 120))};
    if (checked.contains(type)) return {};
    for (const Field& field : fields->second) {
        if (field.kind != Kind::Type) continue;
        if (auto whole = check(field.type, depth + 1, checked); !whole) return whole;
    }
    checked.insert(type);
    return {};
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
        m_ok = m_ok && ++m_depth <= Deepest;
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
