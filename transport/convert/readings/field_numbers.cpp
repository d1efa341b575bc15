#include "transport/convert/readings/field_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/base/unknown.h"
#include "core/messages/number_types.h"
#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/convert/message_catalog.h"

namespace leitstand {
namespace {

/// The first step of a path: "cells[2].voltage" -> "cells", 2, "voltage".
struct Step {
    std::string_view name;
    std::optional<std::size_t> index;
    std::string_view rest;
};

Step firstStep(std::string_view path) {
    Step step;
    const auto end = std::min(path.find('.'), path.size());
    step.name = path.substr(0, end);
    step.rest = path.substr(std::min(end + 1, path.size()));
    const auto open = step.name.find('[');
    if (open == std::string_view::npos) return step;
    const std::string_view digits = step.name.substr(open + 1);
    std::size_t index = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), index);
    step.index = index;
    step.name = step.name.substr(0, open);
    return step;
}

constexpr std::string_view Axes[] = {"x", "y", "z"};

/// Whether a message of these @p fields is a vector.
bool isVector(const MessageFields& fields) {
    return std::equal(fields.begin(), fields.end(), std::begin(Axes), std::end(Axes),
                      [](const MessageField& field, std::string_view axis) {
                          return field.name == axis && !field.array && sizeOfNumber(field.type) > 0;
                      });
}

/// A number to read or to write: the rest of its path, and where it is.
struct Wanted {
    std::string_view path;
    double* number;
};
using AllWanted = std::vector<Wanted>;

/// Returns those of @p wanted that lie in the field @p name, with the rest of their paths; of an array's
/// element @p index only, if given.
AllWanted inField(const AllWanted& wanted, std::string_view name, std::optional<std::size_t> index = {}) {
    AllWanted found;
    for (const Wanted& one : wanted) {
        const Step step = firstStep(one.path);
        if (step.name == name && step.index == index) found.push_back({step.rest, one.number});
    }
    return found;
}

/// Reads a message field by field.
class Reading {
public:
    Reading(const MessageText& text, std::span<const std::byte> message) : m_text(text), m_reader(message) {}

    Result<void> read(const AllWanted& wanted) {
        fields(m_text.fields(), wanted);
        return m_reader.finish();
    }
    [[nodiscard]] const std::string& frame() const { return m_frame; }

private:
    void fields(const MessageFields& all, const AllWanted& wanted) {
        std::uint8_t nothing = 0;
        if (all.empty()) m_reader.read("", nothing);  // messages without fields hold one byte
        for (const MessageField& one : all) {
            if (!m_reader.ok()) return;
            if (!one.array) {
                element(one, inField(wanted, one.name));
            } else if (sizeOfNumber(one.type) > 0) {
                numbers(one, wanted);
            } else {
                std::uint32_t count = one.count.value_or(0);
                if (!one.count) m_reader.read(one.name.c_str(), count);
                for (std::size_t i = 0; i < count && m_reader.ok(); ++i)
                    element(one, inField(wanted, one.name, i));
            }
        }
    }

    void element(const MessageField& one, const AllWanted& wanted) {
        if (isTextType(one.type)) {
            std::string text;
            m_reader.read(one.name.c_str(), text);
            if (one.name == "frame_id" && m_frame.empty()) m_frame = std::move(text);
        } else if (sizeOfNumber(one.type) > 0) {
            withNumberType(one.type, [&](auto number) {
                m_reader.read(one.name.c_str(), number);
                for (const Wanted& to : wanted) *to.number = static_cast<double>(number);
            });
        } else if (const MessageFields* const its = m_text.fieldsOf(one.type)) {
            structure(*its, wanted);
        }
    }

    void structure(const MessageFields& its, const AllWanted& wanted) {
        const bool whole =
            std::any_of(wanted.begin(), wanted.end(), [](const Wanted& to) { return to.path.empty(); });
        if (!whole) return fields(its, wanted);
        double axes[3] = {};
        AllWanted with = wanted;
        for (std::size_t i = 0; i < std::size(axes); ++i) with.push_back({Axes[i], &axes[i]});
        fields(its, with);
        for (const Wanted& to : wanted)
            if (to.path.empty()) *to.number = std::hypot(axes[0], axes[1], axes[2]);
    }

    void numbers(const MessageField& one, const AllWanted& wanted) {
        const auto take = [&](std::size_t size, auto valueAt) {
            for (const Wanted& all : wanted) {
                const Step step = firstStep(all.path);
                if (step.name == one.name && step.index && *step.index < size)
                    *all.number = static_cast<double>(valueAt(*step.index));
            }
        };
        withNumberType(one.type, [&](auto number) {
            using Number = decltype(number);
            if constexpr (sizeof(Number) == 1) {  // pictures: left where they are
                if (!one.count) {
                    std::span<const std::byte> bytes;
                    m_reader.read(one.name.c_str(), bytes);
                    return take(bytes.size(), [&](std::size_t i) { return static_cast<Number>(bytes[i]); });
                }
            }
            std::vector<Number> values;
            if constexpr (!std::is_same_v<Number, bool>) {
                if (!one.count) m_reader.read(one.name.c_str(), values);
            }
            for (std::size_t i = 0; one.count && i < *one.count && m_reader.ok(); ++i) {
                m_reader.read(one.name.c_str(), number);
                values.push_back(number);
            }
            take(values.size(), [&](std::size_t i) { return values[i]; });
        });
    }

    const MessageText& m_text;
    CdrReader m_reader;
    std::string m_frame;
};

/// Writes a message field by field.
class Writing {
public:
    Writing(const MessageText& text, const std::string& frame) : m_text(text), m_frame(frame) {}

    Payload write(const AllWanted& wanted) {
        fields(m_text.fields(), wanted);
        return std::make_shared<const std::vector<std::byte>>(std::move(m_writer).finish());
    }

private:
    void fields(const MessageFields& all, const AllWanted& wanted) {
        if (all.empty()) m_writer.write(std::uint8_t{0});
        for (const MessageField& one : all) {
            if (!one.array) {
                element(one, inField(wanted, one.name));
            } else if (one.count) {
                for (std::size_t i = 0; i < *one.count; ++i) element(one, inField(wanted, one.name, i));
            } else {
                m_writer.write(std::uint32_t{0});
            }
        }
    }

    void element(const MessageField& one, const AllWanted& wanted) {
        if (isTextType(one.type)) {
            m_writer.write(one.name == "frame_id" ? m_frame : std::string());
        } else if (sizeOfNumber(one.type) > 0) {
            withNumberType(one.type, [&](auto number) {
                if (!wanted.empty()) number = static_cast<decltype(number)>(*wanted.front().number);
                m_writer.write(number);
            });
        } else if (const MessageFields* const its = m_text.fieldsOf(one.type)) {
            AllWanted in = wanted;
            for (Wanted& to : in)
                if (to.path.empty()) to.path = Axes[0];  // a vector of this length
            fields(*its, in);
        }
    }

    const MessageText& m_text;
    const std::string m_frame;
    CdrWriter m_writer;
};

/// Where a path leads.
enum class Leads : std::uint8_t { Nowhere, ToANumber, ToAnElement };

Leads ends(const MessageText& text, const MessageFields& fields, std::string_view path, bool open = false) {
    const Step step = firstStep(path);
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const MessageField& one) { return one.name == step.name; });
    if (field == fields.end() || field->array != step.index.has_value()) return Leads::Nowhere;
    if (step.index && field->count && *step.index >= *field->count) return Leads::Nowhere;
    open = open || (field->array && !field->count);
    const Leads found = open ? Leads::ToAnElement : Leads::ToANumber;
    const MessageFields* const its = text.fieldsOf(field->type);
    if (!step.rest.empty()) return its == nullptr ? Leads::Nowhere : ends(text, *its, step.rest, open);
    if (its != nullptr) return isVector(*its) ? found : Leads::Nowhere;
    return sizeOfNumber(field->type) > 0 ? found : Leads::Nowhere;
}

/// The names of @p fields for an error: "header, temperature, variance".
std::string namesOf(const MessageFields& fields) {
    std::string names;
    for (const MessageField& one : fields)
        names += fmt::format("{}{}{}", names.empty() ? "" : ", ", one.name, one.array ? "[]" : "");
    return names;
}

bool hasHeader(const MessageText& text) {
    return !text.fields().empty() && text.fields().front().type == "std_msgs/Header";
}

}  // namespace

Result<void> checkPaths(const MessageText& text, std::span<const std::string> paths) {
    for (const std::string& path : paths) {
        if (ends(text, text.fields(), path) == Leads::Nowhere)
            return Error{fmt::format("expected the path of a number in {} ({}), found \"{}\"", text.type(),
                                     namesOf(text.fields()), path)};
    }
    return {};
}

Result<FieldNumbers> numbersAt(const MessageText& text, std::span<const std::string> paths,
                               std::span<const std::byte> message) {
    if (const auto fit = checkPaths(text, paths); !fit) return fit.error();
    FieldNumbers numbers;
    numbers.values.assign(paths.size(), Unknown);
    AllWanted wanted;
    for (std::size_t i = 0; i < paths.size(); ++i) wanted.push_back({paths[i], &numbers.values[i]});
    double seconds = 0.0, nanoseconds = 0.0;
    if (hasHeader(text)) {
        const std::string& header = text.fields().front().name;
        const std::string sec = header + ".stamp.sec", nanosec = header + ".stamp.nanosec";
        wanted.push_back({sec, &seconds});
        wanted.push_back({nanosec, &nanoseconds});
        Reading reading(text, message);
        if (const auto read = reading.read(wanted); !read) return read.error();
        if (seconds < 0.0 || nanoseconds >= 1e9)
            return Error{
                fmt::format("{}.stamp: expected a time after 1970 with less than 1e9 ns, found {} s "
                            "{} ns",
                            header, seconds, nanoseconds)};
        numbers.header.stamp = Time(std::chrono::seconds(static_cast<std::int64_t>(seconds)) +
                                    std::chrono::nanoseconds(static_cast<std::int64_t>(nanoseconds)));
        numbers.header.frame = reading.frame();
        return numbers;
    }
    if (const auto read = Reading(text, message).read(wanted); !read) return read.error();
    return numbers;
}

Result<Payload> messageWith(const MessageText& text, std::span<const std::string> paths,
                            const FieldNumbers& numbers) {
    if (paths.size() != numbers.values.size())
        return Error{fmt::format("expected {} numbers, found {}", paths.size(), numbers.values.size())};
    for (const std::string& path : paths) {
        if (ends(text, text.fields(), path) != Leads::ToANumber)
            return Error{fmt::format("\"{}\" can not be written in {}", path, text.type())};
    }
    std::vector<double> values = numbers.values;
    const auto stamp = std::chrono::floor<std::chrono::seconds>(numbers.header.stamp.time_since_epoch());
    double seconds = static_cast<double>(stamp.count());
    double nanoseconds = static_cast<double>((numbers.header.stamp.time_since_epoch() - stamp).count());
    AllWanted wanted;
    for (std::size_t i = 0; i < paths.size(); ++i) wanted.push_back({paths[i], &values[i]});
    const std::string header = hasHeader(text) ? text.fields().front().name : std::string();
    const std::string sec = header + ".stamp.sec", nanosec = header + ".stamp.nanosec";
    if (!header.empty()) {
        wanted.push_back({sec, &seconds});
        wanted.push_back({nanosec, &nanoseconds});
    }
    return Writing(text, header.empty() ? std::string() : numbers.header.frame).write(wanted);
}

const MessageText* knownText(std::string_view type) {
    static std::mutex mutex;
    static std::map<std::string, std::unique_ptr<const MessageText>, std::less<>> texts;
    const std::lock_guard lock(mutex);
    if (const auto found = texts.find(type); found != texts.end()) return found->second.get();
    const MessageType* const known = findMessageType(type);
    if (known == nullptr) return nullptr;
    auto parsed = MessageText::parse(std::string(known->rosName), known->definition);
    if (!parsed) return nullptr;
    return texts.emplace(type, std::make_unique<const MessageText>(std::move(parsed).value()))
        .first->second.get();
}

}  // namespace leitstand
