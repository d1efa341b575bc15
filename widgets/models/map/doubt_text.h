#pragma once

#include <cstdint>

#include <QString>

#include "core/event/scan_pose.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// Returns the doubts about a scan (bits of ScanDoubt) in words for the operator: "little overlap, jump";
/// empty: none.
[[nodiscard]] QString doubtText(std::uint8_t doubts);
/// Returns each doubt with its meaning and what may help, one per line; empty: there is none.
[[nodiscard]] QString doubtDetails(std::uint8_t doubts);

/// "certain", "uncertain ?", "set aside".
[[nodiscard]] QString trustText(ScanTrust trust);
[[nodiscard]] Tone toneOf(ScanTrust trust);

}  // namespace leitstand
