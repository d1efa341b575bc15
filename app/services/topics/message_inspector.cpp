#include "app/services/topics/message_inspector.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "core/base/printable.h"
#include "core/base/words.h"
#include "core/messages/number_types.h"
#include "transport/cdr/cdr_reader.h"

namespace leitstand {
namespace {

constexpr std::size_t LongestText = 200;  // [B]
constexpr std::size_t ShownElements = 8;
constexpr std::size_t MostBytes =
    65'536;  ///< longer ones are pictures and clouds: only their beginning is read

template <class Number>
std::string worded(Number number) {
    if constexpr (std::is_same_v<Number, float>) return fmt::format("{:.6g}", number);
    if constexpr (std::is_same_v<Number, double>) return fmt::format("{:.10g}", number);
    if constexpr (std::is_same_v<Number, bool>) return number ? "true" : "false";
    if constexpr (std::is_integral_v<Number>) return fmt::format("{}", number);
}

std::string inQuotes(const std::string& text) {
    const bool longer = text.size() > LongestText;
    return fmt::format("\"{}{}\"", printable(text.substr(0, LongestText)), longer ? "..." : "");
}

/// Numbers of an array; only the first are kept.
class Numbers {
public:
    template <class Number>
    void add(Number number) {
        const auto value = static_cast<double>(number);
        if (m_count < InspectedMessage::MostElements) m_first.emplace_back(worded(number), value);
        ++m_count;
        if (!std::isfinite(value)) return;
        m_least = m_finite ? std::min(m_least, value) : value;
        m_most = m_finite ? std::max(m_most, value) : value;
        m_finite = true;
    }
    /// Adds @p count numbers that are not looked at.
    void skip(std::size_t count) {
        m_count += count;
        m_whole = m_whole && count == 0;
    }
    [[nodiscard]] std::string summary() const {
        std::string text;
        for (std::size_t i = 0; i < std::min({m_count, m_first.size(), ShownElements}); ++i)
            text += fmt::format("{}{}", i == 0 ? "" : ", ", m_first[i].first);
        if (m_count <= ShownElements) return fmt::format("[{}]", text);
        text = leitstand::fill(translate("leitstand::Topics", "{} numbers: {} ..."), m_count, text);
        return m_finite && m_whole ? text + leitstand::fill(translate("leitstand::Topics", " ({} to {})"),
                                                            worded(m_least), worded(m_most))
                                   : text;
    }
    /// Its elements, if there are few; else none.
    [[nodiscard]] const std::vector<std::pair<std::string, double>>* elements() const {
        return m_count <= InspectedMessage::MostElements ? &m_first : nullptr;
    }

private:
    std::vector<std::pair<std::string, double>> m_first;
    std::size_t m_count = 0;
    double m_least = 0.0, m_most = 0.0;
    bool m_finite = false, m_whole = true;
};

class Inspecting {
public:
    Inspecting(const MessageText& text, std::span<const std::byte> message)
        : m_text(text), m_reader(message) {}

    Result<InspectedMessage> read() {
        fields(m_text.fields(), {}, 0);
        if (m_message.cut) return std::move(m_message);
        if (const auto end = m_reader.finish(); !end) return end.error();
        return std::move(m_message);
    }

private:
    [[nodiscard]] bool goesOn() const { return !m_message.cut && m_reader.ok(); }

    void add(InspectedField field) {
        if (m_message.fields.size() >= InspectedMessage::MostFields) {
            m_message.cut = true;
            return;
        }
        m_message.fields.push_back(std::move(field));
    }

    void fields(const MessageFields& all, const std::string& before, int depth) {
        if (all.empty()) {  // messages without fields hold one byte
            std::uint8_t nothing = 0;
            m_reader.read("", nothing);
        }
        for (const MessageField& one : all) {
            if (!goesOn()) return;
            const std::string path = before.empty() ? one.name : fmt::format("{}.{}", before, one.name);
            if (!one.array) {
                element(one, path, depth);
            } else if (sizeOfNumber(one.type) > 0) {
                numbers(one, path, depth);
            } else {
                others(one, path, depth);
            }
        }
    }

    void element(const MessageField& one, const std::string& path, int depth) {
        if (one.type == "string") {
            std::string text;
            m_reader.read(path.c_str(), text);
            if (m_reader.ok()) add({path, inQuotes(text), depth, {}});
        } else if (sizeOfNumber(one.type) > 0) {
            withNumberType(one.type, [&](auto number) {
                m_reader.read(path.c_str(), number);
                if (m_reader.ok()) add({path, worded(number), depth, static_cast<double>(number)});
            });
        } else if (const MessageFields* const its = m_text.fieldsOf(one.type)) {
            add({path, {}, depth, {}});
            fields(*its, path, depth + 1);
        } else {
            m_message.cut = true;  // a wstring, whose letters have no agreed size
        }
    }

    /// Numbers of one byte are looked at where they are, since pictures are such.
    void numbers(const MessageField& one, const std::string& path, int depth) {
        Numbers read;
        withNumberType(one.type, [&](auto number) {
            using Number = decltype(number);
            if (one.count) {
                for (std::uint32_t i = 0; i < *one.count && m_reader.ok(); ++i) {
                    m_reader.read(path.c_str(), number);
                    if (m_reader.ok()) read.add(number);
                }
            } else if constexpr (sizeof(Number) == 1) {
                std::span<const std::byte> bytes;
                m_reader.read(path.c_str(), bytes);
                const std::size_t looked = bytes.size() > MostBytes ? ShownElements : bytes.size();
                for (const std::byte byte : bytes.first(looked)) read.add(static_cast<Number>(byte));
                read.skip(bytes.size() - looked);
            } else {
                std::vector<Number> values;
                m_reader.read(path.c_str(), values);
                for (const Number value : values) read.add(value);
            }
        });
        if (!m_reader.ok()) return;
        add({path, read.summary(), depth, {}});
        const auto* const elements = read.elements();
        if (elements == nullptr) return;
        for (std::size_t i = 0; i < elements->size(); ++i) {
            const auto& [words, value] = (*elements)[i];
            add({fmt::format("{}[{}]", path, i), words, depth + 1, value});
        }
    }

    void others(const MessageField& one, const std::string& path, int depth) {
        std::uint32_t count = one.count.value_or(0);
        if (!one.count) m_reader.read(path.c_str(), count);
        if (!m_reader.ok()) return;
        add({path, leitstand::fill(translate("leitstand::Topics", "{} elements"), count), depth, {}});
        MessageField single = one;
        single.array = false;
        for (std::uint32_t i = 0; i < count && goesOn(); ++i)
            element(single, fmt::format("{}[{}]", path, i), depth + 1);
    }

    const MessageText& m_text;
    CdrReader m_reader;
    InspectedMessage m_message;
};

}  // namespace

Result<InspectedMessage> inspect(const MessageText& text, std::span<const std::byte> message) {
    return Inspecting(text, message).read();
}

std::optional<double> numberAt(const InspectedMessage& message, const std::string& path) {
    const auto found = std::find_if(message.fields.begin(), message.fields.end(),
                                    [&](const InspectedField& field) { return field.path == path; });
    return found == message.fields.end() ? std::nullopt : found->number;
}

}  // namespace leitstand
