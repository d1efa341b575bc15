#pragma once

#include "app/services/log/event_decoder.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/fold.h"

namespace leitstand {

/// The past of a mission, decoded from its bag.
class BagHistory final : public MissionHistory {
public:
    /// @p bag and @p decoder must outlive the history.
    BagHistory(BagReader& bag, EventDecoder& decoder) : m_bag(bag), m_decoder(decoder) {}

    [[nodiscard]] std::optional<StoredCheckpoint> checkpointUpTo(std::uint64_t sequence) override;
    void events(std::uint64_t after, std::uint64_t upTo,
                const std::function<void(const Event&)>& take) override;

private:
    BagReader& m_bag;
    EventDecoder& m_decoder;
};

}  // namespace leitstand
