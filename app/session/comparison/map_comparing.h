#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/session/review/review_index.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

/// The finished map of the mission @p folder, whose @p index is known, beside that which @p settings make of
/// its key scans; errors where the truth would be known, too. Nothing of the mission is changed. An error
/// when it has no key scans; null when cancelled.
[[nodiscard]] Result<MapComparisonPtr> compareMaps(const std::filesystem::path& folder,
                                                   const ReviewIndex& index,
                                                   const RegistrationSettings& settings,
                                                   const Progress& progress = {});

/// Compares maps on a thread of its own. Any thread may call; nothing waits.
class MapComparing {
public:
    /// Called on its thread; may be empty.
    struct Listener {
        std::function<void(double fraction)> onProgress = {};
        std::function<void(const Result<MapComparisonPtr>&)> onFinished = {};  ///< as of compareMaps()
    };
    explicit MapComparing(Listener listener);
    ~MapComparing();  ///< cancels and waits for a step of the registration at most
    MapComparing(const MapComparing&) = delete;
    MapComparing& operator=(const MapComparing&) = delete;

    void begin(std::filesystem::path folder, ReviewIndexPtr index, RegistrationSettings settings);
    void cancel();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
