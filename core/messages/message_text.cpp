#include "core/messages/message_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <utility>

#include "core/base/words.h"

namespace leitstand {
namespace {

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

/// Returns the name without "/msg": "sensor_msgs/LaserScan".
std::string shortName(std::string_view type) {
    std::string name(type);
    if (const auto middle = name.find("/msg/"); middle != std::string::npos) name.erase(middle, 4);
    return name;
}

bool isPlain(std::string_view type) {
    return sizeOfNumber(type) > 0 || isTextType(type) || type == "time" || type == "duration";
}

/// Returns @p name as the key of its type, seen from @p current: "Point" in geometry_msgs is
/// "geometry_msgs/Point".
std::string resolved(const std::string& name, const std::string& current) {
    if (isPlain(name)) return name;
    if (name == "Header") return "std_msgs/Header";
    if (name.find('/') != std::string::npos) return shortName(name);
    return current.substr(0, current.find('/')) + "/" + name;
}

Result<MessageField> fieldOf(std::string_view word, const std::string& current) {
    const auto refuse = [&word] {
        return Error{leitstand::fill(translate("leitstand::Error", "expected a type, found \"{}\""),
                                     std::string(word.substr(0, 80)))};
    };
    MessageField field;
    std::string_view name = word;
    if (const auto bracket = name.find('['); bracket != std::string_view::npos) {
        field.array = true;
        std::string_view count = name.substr(bracket + 1);
        if (!count.ends_with(']')) return refuse();
        count.remove_suffix(1);
        name = name.substr(0, bracket);
        if (count.starts_with("<=")) count = {};  // a bound: the message holds the length
        if (!count.empty()) {
            std::uint32_t number = 0;
            const auto read = std::from_chars(count.data(), count.data() + count.size(), number);
            if (read.ec != std::errc() || read.ptr != count.data() + count.size()) return refuse();
            field.count = number;
        }
    }
    name = name.substr(0, name.find("<="));
    if (name.empty()) return refuse();
    field.type = resolved(std::string(name), current);
    return field;
}

}  // namespace

std::size_t sizeOfNumber(std::string_view type) {
    const auto* const known =
        std::find_if(Numbers.begin(), Numbers.end(), [&](const auto& one) { return one.first == type; });
    return known == Numbers.end() ? 0 : known->second;
}

bool isTextType(std::string_view type) {
    return type == "string" || type == "wstring";
}

const MessageFields* MessageText::fieldsOf(const std::string& type) const {
    const auto found = m_types.find(type);
    return found == m_types.end() ? nullptr : &found->second;
}

Result<MessageText> MessageText::parse(const std::string& type, std::string_view definition) {
    if (definition.size() > Longest)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected a text of at most {} bytes"),
                                     type, Longest)};
    MessageText text;
    text.m_type = shortName(type);
    std::string current = text.m_type;
    text.m_types[current];
    std::optional<Error> problem;
    forEachLine(definition, [&](std::string_view line) {
        if (problem || line.starts_with("===")) return;
        if (line.starts_with("MSG:")) {
            current = shortName(trimmed(line.substr(4)));
            text.m_types[current].clear();
            return;
        }
        line = trimmed(line.substr(0, line.find('#')));
        const auto space = line.find_first_of(" \t");
        if (line.empty() || space == std::string_view::npos) return;
        std::string_view name = trimmed(line.substr(space));
        if (name.find('=') != std::string_view::npos && name.find('=') < name.find_first_of("\"'"))
            return;                                        // a constant
        name = name.substr(0, name.find_first_of(" \t"));  // before a default
        auto field = fieldOf(line.substr(0, space), current);
        if (!field) {
            problem = Error{current + ": " + field.error().text};
            return;
        }
        MessageField made = std::move(field).value();
        made.name = std::string(name);
        text.m_types[current].push_back(std::move(made));
    });
    if (problem) return *problem;
    // Some writers leave these out.
    for (const char* const moment : {"builtin_interfaces/Time", "builtin_interfaces/Duration"})
        text.m_types.try_emplace(
            moment, MessageFields{{"int32", "sec", false, {}}, {"uint32", "nanosec", false, {}}});
    if (const auto whole = text.check(); !whole) return whole.error();
    return text;
}

Result<void> MessageText::check() const {
    // Types that are in another one on the way to it, or known to be whole.
    std::set<std::string> whole;
    const auto look = [&](const auto& again, const std::string& type, int depth) -> Result<void> {
        if (whole.contains(type)) return {};
        const MessageFields* const its = fieldsOf(type);
        if (its == nullptr || depth > Deepest)
            return Error{leitstand::fill(translate("leitstand::Error", "{}: its text lacks the type {}"),
                                         m_type, type.substr(0, 120))};
        for (const MessageField& field : *its) {
            if (isPlain(field.type)) continue;
            if (auto inner = again(again, field.type, depth + 1); !inner) return inner;
        }
        whole.insert(type);
        return {};
    };
    return look(look, m_type, 0);
}

}  // namespace leitstand
