#pragma once

#include <cstdint>

namespace leitstand {

struct FindSample;
struct VictimEvidence;
class BagReader;
class EventDecoder;

/// Returns the sequence of the event in the mission @p bag that is @p evidence of @p find; 0: this log does
/// not have it. Evidence from this station has a sequence, but evidence from another station does not. Then
/// the event is found by topic and stamp. It must have been received within a minute of that stamp, or of
/// FindSample::found if clocks differ.
[[nodiscard]] std::uint64_t sequenceInLog(BagReader& bag, EventDecoder& decoder,
                                          const VictimEvidence& evidence, const FindSample& find);

}  // namespace leitstand
