#include "app/services/log/replay/bag_history.h"

#include "app/services/log/decoded_log.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"

namespace leitstand {

std::optional<MissionHistory::StoredCheckpoint> BagHistory::checkpointUpTo(std::uint64_t sequence) {
    const auto raw = m_bag.lastUpTo(std::string(station_topic::Checkpoints), sequence);
    if (!raw) return std::nullopt;
    std::optional<StoredCheckpoint> found;
    m_decoder.decode(*raw, [&](const Event& event) {
        if (const auto* checkpoint = event.sample.as<CheckpointSample>()) {
            found = StoredCheckpoint{event.sequence, *checkpoint};
        }
    });
    return found;
}

void BagHistory::events(std::uint64_t after, std::uint64_t upTo,
                        const std::function<void(const Event&)>& take) {
    BagQuery query;
    query.fromSequence = after + 1;
    query.toSequence = upTo;
    // Pictures and clouds that nobody folds need not be read.
    for (const BagTopic& topic : m_bag.topics()) {
        if (m_decoder.knows(topic.info.name)) query.topics.push_back(topic.info.name);
    }
    forEachEvent(m_bag, m_decoder, query, take);
}

}  // namespace leitstand
