#include "transport/services/type_description.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/printable.h"
#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"

namespace leitstand {
namespace {

// type_description_interfaces/msg/FieldType: a kind, and how often it is there.
constexpr std::uint8_t Nested = 1, FixedString = 19, BoundedString = 21, PerForm = 48;
constexpr std::uint8_t Single = 0, Array = 1, BoundedSequence = 2, Sequence = 3;
/// Types as .msg files name them, by their kinds; empty: not read by the station.
constexpr std::array<std::string_view, 20> Kinds = {
    "",        "",        "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64",   "uint64",
    "float32", "float64", "",     "uint8", "",      "bool",   "byte",  "string", "wstring", ""};

/// type_description_interfaces/msg/Field, without its default.
struct Field {
    static constexpr std::size_t LeastSize = 4 + 1 + 8 + 8 + 4 + 4;
    std::string name, nested;
    std::uint8_t type = 0;
    std::uint64_t capacity = 0;
};
void decode(CdrReader& in, Field& to) {
    std::uint64_t stringCapacity = 0;
    std::string usual;
    in.read("name", to.name);
    in.read("type_id", to.type);
    in.read("capacity", to.capacity);
    in.read("string_capacity", stringCapacity);
    in.read("nested_type_name", to.nested);
    in.read("default_value", usual);
}
void encode(CdrWriter& out, const Field& from) {
    out.write(from.name);
    out.write(from.type);
    out.write(from.capacity);
    out.write(std::uint64_t{0});
    out.write(from.nested);
    out.write(std::string());
}

/// type_description_interfaces/msg/IndividualTypeDescription.
struct OneType {
    static constexpr std::size_t LeastSize = 4 + 4;
    std::string name;
    std::vector<Field> fields;
};
void decode(CdrReader& in, OneType& to) {
    in.read("type_name", to.name);
    in.read("fields", to.fields);
}
void encode(CdrWriter& out, const OneType& from) {
    out.write(from.name);
    out.write(static_cast<std::uint32_t>(from.fields.size()));
    for (const Field& field : from.fields) encode(out, field);
}

/// "geometry_msgs/msg/Point" -> "geometry_msgs/Point".
std::string withoutMsg(std::string name) {
    constexpr std::string_view Middle = "/msg/";
    if (const std::size_t at = name.find(Middle); at != std::string::npos) name.erase(at, Middle.size() - 1);
    return name;
}
/// "geometry_msgs/Point" -> "geometry_msgs/msg/Point".
std::string withMsg(std::string name) {
    if (const std::size_t slash = name.find('/'); slash != std::string::npos) name.insert(slash, "/msg");
    return name;
}

/// Whether @p name can be one of a field or a type, "pose", "geometry_msgs/msg/Pose".
bool isName(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '/';
    });
}

Result<std::string> lineOf(const Field& field) {
    if (!isName(field.name) || (!field.nested.empty() && !isName(field.nested)))
        return Error{fmt::format("expected the name of a field, found {}", printable(field.name))};
    const std::uint8_t kind = field.type % PerForm, form = field.type / PerForm;
    const bool text = kind == FixedString || kind == BoundedString;
    std::string type = kind == Nested ? withoutMsg(field.nested) : text ? "string" : std::string();
    if (type.empty() && kind < Kinds.size()) type = Kinds[kind];
    if (type.empty() || form > Sequence)
        return Error{
            fmt::format("field {} is of kind {}, which is not read", printable(field.name), field.type)};
    if (form == Array)
        type += fmt::format("[{}]", field.capacity);
    else if (form == BoundedSequence || form == Sequence)
        type += "[]";
    return fmt::format("{} {}\n", type, field.name);
}

Result<std::string> textOf(const OneType& type) {
    if (!isName(type.name)) return Error{fmt::format("expected a type, found {}", printable(type.name))};
    std::string text;
    for (const Field& field : type.fields) {
        const auto line = lineOf(field);
        if (!line) return line.error();
        text += *line;
    }
    return text;
}

Payload payloadOf(CdrWriter&& out) {
    return std::make_shared<const std::vector<std::byte>>(std::move(out).finish());
}

Field fieldOf(const MessageField& from) {
    Field field;
    field.name = from.name;
    // From the first kind that has a name on.
    const auto* const kind = std::find(Kinds.begin() + 2, Kinds.end(), from.type);
    if (kind != Kinds.end()) field.type = static_cast<std::uint8_t>(kind - Kinds.begin());
    if (field.type == 0) {
        field.type = Nested;
        field.nested = withMsg(from.type);
    }
    const std::uint8_t form = !from.array ? Single : from.count ? Array : Sequence;
    field.type = static_cast<std::uint8_t>(field.type + form * PerForm);
    field.capacity = from.count.value_or(0);
    return field;
}

}  // namespace

Payload encodeTypeRequest(const TypeRequest& request) {
    CdrWriter out;
    out.write(request.type);
    out.write(request.hash);
    out.write(false);  // include_type_sources
    return payloadOf(std::move(out));
}

Result<TypeRequest> decodeTypeRequest(std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    TypeRequest request;
    bool sources = false;
    in.read("type_name", request.type);
    in.read("type_hash", request.hash);
    in.read("include_type_sources", sources);
    if (const auto done = in.finish(); !done) return done.error();
    return request;
}

Payload encodeTypeAnswer(const MessageText& text, const std::string& reason) {
    OneType main;
    std::vector<OneType> others;
    for (const auto& [name, fields] : text.types()) {
        OneType one{withMsg(name), {}};
        for (const MessageField& field : fields) one.fields.push_back(fieldOf(field));
        if (name == text.type())
            main = std::move(one);
        else
            others.push_back(std::move(one));
    }
    CdrWriter out;
    out.write(reason.empty());
    out.write(reason);
    encode(out, main);
    out.write(static_cast<std::uint32_t>(others.size()));
    for (const OneType& one : others) encode(out, one);
    out.write(std::uint32_t{0});  // type_sources
    out.write(std::uint32_t{0});  // extra_information
    return payloadOf(std::move(out));
}

Result<MessageText> decodeTypeAnswer(std::span<const std::byte> bytes, const std::string& type) {
    CdrReader in(bytes);
    bool successful = false;
    std::string reason;
    OneType main;
    std::vector<OneType> others;
    in.read("successful", successful);
    in.read("failure_reason", reason);
    in.read("type_description", main);
    in.read("referenced_type_descriptions", others);
    // Its sources, which were not asked for, are left.
    if (!in.ok()) return in.finish().error();
    if (!successful) return Error{reason.empty() ? "the node knows no such type" : printable(reason)};
    if (main.name != type)
        return Error{fmt::format("expected {}, found {}", printable(type), printable(main.name))};
    auto text = textOf(main);
    if (!text) return text.error();
    std::string all = std::move(text).value();
    for (const OneType& one : others) {
        const auto more = textOf(one);
        if (!more) return more.error();
        all += std::string(80, '=') + "\nMSG: " + withoutMsg(one.name) + "\n" + *more;
        if (all.size() > MessageText::Longest) break;  // refused by its length
    }
    return MessageText::parse(type, all);
}

}  // namespace leitstand
