#include "app/services/log/decoded_log.h"

#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/io/bag/raw_events.h"

namespace leitstand {

void forEachEvent(BagReader& bag, EventDecoder& decoder, const BagQuery& query,
                  const std::function<void(const Event&)>& take, const Progress& progress) {
    if (query.topics.empty()) return;
    const auto decode = [&](const RawEvent& raw) {
        decoder.decode(raw, take);
        return true;
    };
    forEachRaw(bag, query, decode, progress);
}

}  // namespace leitstand
