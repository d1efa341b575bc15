#include "transport/convert/decode.h"

#include <algorithm>

#include "core/event/all_samples.h"
#include "core/event/event.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/robot/frame_names.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/detail/conversion.h"
#include "transport/convert/readings/reading_conversion.h"

namespace leitstand {
namespace {

using detail::Conversion;

bool serves(const Conversion& entry, const StreamDescription* stream) {
    if (stream == nullptr || entry.ofStations) return stream == nullptr && entry.ofStations;
    const auto types = typesOf(stream->role);
    return std::find(types.begin(), types.end(), entry.type) != types.end();
}

/// Returns the types that @p stream may have, as text for an error.
std::string expectedTypes(const StreamDescription* stream) {
    std::string text;
    for (const Conversion& entry : detail::conversions()) {
        if (!serves(entry, stream)) continue;
        text += (text.empty() ? "" : ", ") + std::string(entry.type);
    }
    return text;
}

Result<Sample> decodeFor(const RawEvent& event, const StreamDescription* stream) {
    const auto fail = [&](const std::string& text) {
        return Error{fmt::format("{}: {}: {}", event.topic, event.type, text)};
    };
    if (event.cdr == nullptr) return fail("there are no bytes");
    if (stream != nullptr && stream->role == StreamRole::Reading) {
        auto reading = detail::decodeReading(event, *stream);
        return reading ? std::move(reading) : fail(reading.error().text);
    }
    const auto& all = detail::conversions();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Conversion& entry) {
        return entry.type == event.type && serves(entry, stream);
    });
    if (found == all.end()) {
        return fail(fmt::format("expected {} for {}", expectedTypes(stream),
                                stream == nullptr ? "a station's own topic" : toString(stream->role)));
    }
    auto sample = found->decode(event, stream);
    if (!sample) return fail(sample.error().text);
    return sample;
}

/// Names the frames of @p sample after its robot.
template <class Kind>
void nameFrames(Kind& sample, const RobotDescription& robot) {
    if constexpr (requires { sample.header.frame; }) {
        sample.header.frame = frameName(robot, sample.header.frame);
    }
    if constexpr (requires { sample.childFrame; }) sample.childFrame = frameName(robot, sample.childFrame);
}

void nameFrames(MarkersSample& sample, const RobotDescription& robot) {
    for (Marker& marker : sample.markers) nameFrames(marker, robot);
}

void nameFrames(TransformsSample& sample, const RobotDescription& robot) {
    std::erase_if(sample.transforms, [&](const FrameTransform& transform) {
        return !isOwnTransform(robot, transform.header.frame, transform.childFrame);
    });
    for (FrameTransform& transform : sample.transforms) nameFrames(transform, robot);
}

}  // namespace

Result<Sample> decode(const RawEvent& event, const StreamDescription& stream) {
    return decodeFor(event, &stream);
}

Result<Event> decodeEvent(const RawEvent& event, const RobotDescription& robot,
                          const StreamDescription& stream) {
    auto sample = decodeFor(event, &stream);
    if (!sample) return sample.error();
    Sample content = std::move(sample).value();
    edit([&](auto& kind) { nameFrames(kind, robot); }, content);
    return Event{event.sequence, event.received, robot.name,        event.topic,
                 stream.role,    stream.sensor,  std::move(content)};
}

Result<Event> decodeStationEvent(const RawEvent& event) {
    auto sample = decodeFor(event, nullptr);
    if (!sample) return sample.error();
    return Event{event.sequence,           event.received, {}, event.topic, std::nullopt, {},
                 std::move(sample).value()};
}

}  // namespace leitstand
