#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/event/sample.h"
#include "core/robot/robot_description.h"
#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/convert/detail/checks.h"

namespace leitstand::detail {

/// Where a message comes from.
struct Source {
    const Payload& cdr;
    const StreamDescription* stream = nullptr;  ///< null for the stations' own topics
};

/// Holds bytes that a message only points to, until it is written.
using Buffer = std::vector<std::byte>;

/// How a type of message becomes a sample of core, and back. typesOf() lists the types that a robot's stream
/// may have.
struct Conversion {
    std::string_view type;  ///< ROS name
    Result<Sample> (*decode)(const RawEvent&, const StreamDescription*);
    Result<Payload> (*encode)(const Sample&);  ///< null: Leitstand never sends it
    std::size_t kind;                          ///< kind of the sample: Sample::index()
    bool ofStations;                           ///< whether it is for the stations' own topics
};

template <class Message>
Result<Sample> decodeAs(const RawEvent& event, const StreamDescription* stream) {
    CdrReader in(*event.cdr);
    Message message;
    decode(in, message);
    if (const auto end = in.finish(); !end) return end.error();
    Checks checks;
    auto sample = fromWire(message, Source{event.cdr, stream}, checks);
    if (!checks.ok()) return Error{checks.error()};
    return Sample(std::move(sample));
}

/// Estimates the size of a message [B]. Reserving it avoids copies while the message is written.
template <class Message>
std::size_t bulk(const Message& message) {
    std::size_t size = 256;
    if constexpr (requires { message.data.size_bytes(); }) size += message.data.size_bytes();
    if constexpr (requires { message.points; }) size += message.points.size() * sizeof(float) * 2;
    if constexpr (requires { message.state.size_bytes(); }) size += message.state.size_bytes();
    return size;
}

template <class Kind, class Message>
Result<Payload> encodeAs(const Sample& sample) {
    const Kind* from = sample.as<Kind>();
    if (from == nullptr) return Error{"it cannot say samples of this kind"};
    Checks checks;
    Buffer buffer;
    Message message;
    toWire(*from, message, buffer, checks);
    if (!checks.ok()) return Error{checks.error()};
    CdrWriter out;
    out.reserve(bulk(message));
    encode(out, message);
    return Payload(std::make_shared<const std::vector<std::byte>>(std::move(out).finish()));
}

/// Returns the row for messages of type @p Message and samples of type @p Kind. The row calls two functions
/// that must be declared in this namespace.
///
///     Kind fromWire(const Message& from, const Source& source, Checks& checks);
///     void toWire(const Kind& from, Message& to, Buffer& buffer, Checks& checks);
///
/// @p checks keeps the first error. The result is valid only if there is none.
template <class Message, class Kind>
Conversion conversion() {
    return {Message::RosName, &decodeAs<Message>, &encodeAs<Kind, Message>, SampleTypes::indexOf<Kind>(),
            false};
}
template <class Message, class Kind>
Conversion stationConversion() {
    Conversion row = conversion<Message, Kind>();
    row.ofStations = true;
    return row;
}
/// Returns a row for a message that is only received; it needs no toWire().
template <class Message, class Kind>
Conversion decoding() {
    return {Message::RosName, &decodeAs<Message>, nullptr, SampleTypes::indexOf<Kind>(), false};
}

/// Returns all rows. If a kind of sample has several types, the type of its first row can hold everything.
[[nodiscard]] const std::vector<Conversion>& conversions();

// The rows of each source file.
[[nodiscard]] std::vector<Conversion> cloudConversions();
[[nodiscard]] std::vector<Conversion> markerConversions();
[[nodiscard]] std::vector<Conversion> motionConversions();
[[nodiscard]] std::vector<Conversion> navigationConversions();
[[nodiscard]] std::vector<Conversion> pictureConversions();
[[nodiscard]] std::vector<Conversion> statusConversions();
[[nodiscard]] std::vector<Conversion> commandConversions();
[[nodiscard]] std::vector<Conversion> jointConversions();
[[nodiscard]] std::vector<Conversion> mapConversions();
[[nodiscard]] std::vector<Conversion> stationConversions();
[[nodiscard]] std::vector<Conversion> victimConversions();

}  // namespace leitstand::detail
