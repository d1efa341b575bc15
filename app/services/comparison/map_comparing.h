#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/services/recorded/review_index.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

/// A comparison and the maps that it shows; each map is made once. Immutable once shared.
struct ComparedMaps {
    MapComparisonPtr comparison;  ///< never null
    MapPtr again, both;           ///< results of mapOf() for ComparedMap::Again and Both
    bool remembered = false;      ///< whether it was made earlier and read from the mission's folder
};
using ComparedMapsPtr = std::shared_ptr<const ComparedMaps>;

/// Compares the final map of the mission @p folder with the map that its key scans give when they are
/// registered again with @p settings. @p index: index of the mission. Includes errors if the mission has
/// ground truth. Changes nothing in the mission. Error when it has no key scans; null when cancelled.
[[nodiscard]] Result<MapComparisonPtr> compareMaps(const std::filesystem::path& folder,
                                                   const ReviewIndex& index,
                                                   const RegistrationSettings& settings,
                                                   const Progress& progress = {});

/// Returns the file in which a mission's newest comparison is kept.
[[nodiscard]] std::filesystem::path comparisonFileOf(const std::filesystem::path& folder);
/// Returns the comparison kept with the mission @p folder; null when there is none. Errors are those of
/// readComparison(), or that its scans are not those of the mission.
[[nodiscard]] Result<MapComparisonPtr> keptComparison(const std::filesystem::path& folder,
                                                      const ReviewIndex& index);

/// Compares maps on its own thread. Any thread may call; no call blocks.
class MapComparing {
public:
    /// Called on the thread of MapComparing. Each function may be empty.
    struct Listener {
        std::function<void(double fraction)> onProgress = {};
        std::function<void(const Result<ComparedMapsPtr>&)> onFinished =
            {};  ///< with the result of compareMaps(); null: cancelled
        std::function<void(const std::string&)> onMessage =
            {};  ///< with the reason why a result could not be kept or recalled
    };
    explicit MapComparing(Listener listener);
    ~MapComparing();  ///< cancels; waits for at most one step of the registration
    MapComparing(const MapComparing&) = delete;
    MapComparing& operator=(const MapComparing&) = delete;

    /// Compares like compareMaps(). Keeps the result in the mission's folder, unless others recorded the
    /// mission (isOfOthers()).
    void begin(std::filesystem::path folder, ReviewIndexPtr index, RegistrationSettings settings);
    /// Reports the kept comparison, if there is one, with onFinished. If it is no longer valid, reports this
    /// with onMessage.
    void recall(std::filesystem::path folder, ReviewIndexPtr index);
    void cancel();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
