#pragma once

#include <cstdint>

namespace leitstand {

struct FindSample;
struct VictimEvidence;
class BagReader;
class EventDecoder;

/// Returns the event of the mission @p bag that is @p evidence of @p find: the one whose sequence it names.
/// Evidence from another station names none. It is the event of its topic with the same stamp, received
/// within a minute of that stamp or of the find, by whichever clock. 0: this log does not have it.
[[nodiscard]] std::uint64_t sequenceInLog(BagReader& bag, EventDecoder& decoder,
                                          const VictimEvidence& evidence, const FindSample& find);

}  // namespace leitstand
