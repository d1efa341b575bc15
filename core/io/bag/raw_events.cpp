#include "core/io/bag/raw_events.h"

#include <algorithm>
#include <cstdint>

#include "core/event/raw_event.h"

namespace leitstand {

void forEachRaw(BagReader& bag, const BagQuery& query, const std::function<bool(RawEvent&)>& take,
                const Progress& progress) {
    BagCursor cursor = bag.read(query);
    const auto last = static_cast<double>(std::max<std::uint64_t>(bag.lastSequence(), 1));
    while (auto raw = cursor.next()) {
        const auto sequence = static_cast<double>(raw->sequence);
        if (!take(*raw)) return;
        progress.done(sequence / last);
        if (progress.cancelled()) return;
    }
}

}  // namespace leitstand
