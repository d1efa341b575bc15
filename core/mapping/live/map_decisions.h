#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/mapping/live/growing_map.h"
#include "core/mapping/live/map/map_update.h"

namespace leitstand {

/// Carries out decisions about the key scans of a map, from the operator or from the log. Functions are
/// documented in LiveMapper.
class MapDecisions {
public:
    explicit MapDecisions(GrowingMap& map) : m_map(map) {}

    [[nodiscard]] Result<ScanPosesSample> accept(std::uint64_t id, Time now);
    [[nodiscard]] Result<ScanPosesSample> reject(std::uint64_t id, Time now);
    [[nodiscard]] Result<ScanPosesSample> retry(std::uint64_t id, const RetrySettings& settings, Time now);
    [[nodiscard]] Result<ScanPosesSample> rewind(Time moment, Time now);
    void restore(const KeyScanSample& sample);
    void adopt(const KeyScanSample& sample);
    void beginBlock();
    void follow(std::span<const ScanPose> poses);
    [[nodiscard]] std::optional<ScanLinksSample> takeLinks() { return std::exchange(m_made, std::nullopt); }

private:
    [[nodiscard]] ScanPosesSample decided(std::vector<ScanPose> poses, Time now);
    /// Replaces the links of the scan @p id, which was registered again against the scans @p against.
    void linkAgain(std::uint64_t id, std::span<const std::uint64_t> against, const Match& match, Time now);

    GrowingMap& m_map;
    std::optional<ScanLinksSample> m_made;  ///< links that the last decision changed
};

}  // namespace leitstand
