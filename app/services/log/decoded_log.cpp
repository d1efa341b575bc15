#include "app/services/log/decoded_log.h"

#include <algorithm>

#include "app/services/log/log_entry.h"
#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/io/bag/raw_events.h"

namespace leitstand {

void forEachEvent(BagReader& bag, EventDecoder& decoder, const BagQuery& query,
                  const std::function<void(const Event&)>& take, const Progress& progress) {
    if (query.topics.empty()) return;
    const std::uint64_t first = std::max(query.fromSequence, query.from ? bag.sequenceAt(*query.from) : 0);
    enterLog(bag, decoder, first == 0 ? 0 : first - 1, query.topics);
    const auto decode = [&](const RawEvent& raw) {
        decoder.decode(raw, take);
        return true;
    };
    forEachRaw(bag, query, decode, progress);
    if (!query.to && !progress.cancelled()) decoder.arrived(query.toSequence, query.topics);
}

}  // namespace leitstand
