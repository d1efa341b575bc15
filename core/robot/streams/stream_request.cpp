#include "core/robot/streams/stream_request.h"

#include <algorithm>

namespace leitstand {
namespace {

/// The smaller of two limits; 0 is no limit.
template <class T>
T lower(T one, T other) {
    if (one <= T{}) return other;
    return other <= T{} ? one : std::min(one, other);
}

}  // namespace

StreamRequest stricter(const StreamRequest& one, const StreamRequest& other) {
    return {.enabled = one.enabled && other.enabled,
            .rate = lower(one.rate, other.rate),
            .quality = lower(one.quality, other.quality),
            .maxWidth = lower(one.maxWidth, other.maxWidth)};
}

bool isFollowed(const StreamRequest& request, const StreamStatus& stream) {
    // Rates are taken over some seconds, so a stream that was just switched off still has one.
    if (!request.enabled) return stream.rate <= 0.0 || stream.age > 1.0;
    return request.rate <= 0.0 || stream.rate <= 1.3 * request.rate + 0.3;
}

StreamCommandSample commandOf(const std::string& topic, const StreamRequest& request) {
    StreamCommandSample command;
    command.topic = topic;
    command.enabled = request.enabled;
    command.rate = request.rate;
    command.quality = request.quality;
    command.maxWidth = request.maxWidth;
    return command;
}

}  // namespace leitstand
