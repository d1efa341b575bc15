#pragma once

#include <cstdint>
#include <optional>

#include <QString>

#include "core/mission/finds/find_book.h"

namespace leitstand {

/// The offer to merge a find with the nearest find of its kind.
struct MergeOffer {
    std::optional<std::uint32_t> into;  ///< number of the find to merge it with; empty: it cannot be merged
    QString text;                       ///< "V2 is part of V1 now, 0.3 m away", or why it cannot be merged
};

[[nodiscard]] MergeOffer mergeOffer(const MissionState& state, const FindKey& find);

}  // namespace leitstand
