#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace leitstand {

class BagReader;
class EventDecoder;
struct Event;
struct RawEvent;

/// Returns the newest picture of the video on @p topic up to @p sequence, with all that it is decoded from.
/// These are the events of the topic from its key picture on. Empty when the topic holds no video, or no key
/// picture within the 20 s before. Afterwards @p decoder goes on from there.
[[nodiscard]] std::vector<RawEvent> videoUpTo(BagReader& bag, EventDecoder& decoder, const std::string& topic,
                                              std::uint64_t sequence);

/// Makes @p decoder ready for the events of @p bag after @p sequence: pictures of videos among them follow
/// those before, and the calibrations of depth cameras are known. @p topics: those that will be read; empty:
/// all.
void enterLog(BagReader& bag, EventDecoder& decoder, std::uint64_t sequence,
              const std::vector<std::string>& topics = {});

/// Decodes @p event of @p bag by itself. Of several events on a topic that robots share, returns the first.
/// Empty when it cannot be decoded.
[[nodiscard]] std::optional<Event> decodedAlone(BagReader& bag, EventDecoder& decoder, const RawEvent& event);

}  // namespace leitstand
