#include "core/robot/streams/stream_wish.h"

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

StreamWish stricter(const StreamWish& one, const StreamWish& other) {
    return {.enabled = one.enabled && other.enabled,
            .rate = lower(one.rate, other.rate),
            .quality = lower(one.quality, other.quality),
            .maxWidth = lower(one.maxWidth, other.maxWidth)};
}

bool isFollowed(const StreamWish& wish, const StreamStatus& stream) {
    // Rates are taken over some seconds, so a stream that was just switched off still has one.
    if (!wish.enabled) return stream.rate <= 0.0 || stream.age > 1.0;
    return wish.rate <= 0.0 || stream.rate <= 1.3 * wish.rate + 0.3;
}

StreamCommandSample commandOf(const std::string& topic, const StreamWish& wish) {
    StreamCommandSample command;
    command.topic = topic;
    command.enabled = wish.enabled;
    command.rate = wish.rate;
    command.quality = wish.quality;
    command.maxWidth = wish.maxWidth;
    return command;
}

}  // namespace leitstand
