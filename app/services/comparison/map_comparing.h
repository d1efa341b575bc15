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

/// A comparison and the maps that it shows, made once. Immutable once shared.
struct ComparedMaps {
    MapComparisonPtr comparison;  ///< never null
    MapPtr again, both;           ///< as of mapOf()
    bool remembered = false;      ///< made earlier, and read from the mission's folder
};
using ComparedMapsPtr = std::shared_ptr<const ComparedMaps>;

/// The finished map of the mission @p folder, whose @p index is known, beside that which @p settings make of
/// its key scans; errors where the truth would be known, too. Nothing of the mission is changed. An error
/// when it has no key scans; null when cancelled.
[[nodiscard]] Result<MapComparisonPtr> compareMaps(const std::filesystem::path& folder,
                                                   const ReviewIndex& index,
                                                   const RegistrationSettings& settings,
                                                   const Progress& progress = {});

/// Where a mission's newest comparison is kept.
[[nodiscard]] std::filesystem::path comparisonFileOf(const std::filesystem::path& folder);
/// The comparison that was kept with the mission @p folder; null: none was. Errors as of readComparison(),
/// and when it is of scans that the mission does not have.
[[nodiscard]] Result<MapComparisonPtr> keptComparison(const std::filesystem::path& folder,
                                                      const ReviewIndex& index);

/// Compares maps on a thread of its own. Any thread may call; nothing waits.
class MapComparing {
public:
    /// Called on its thread; may be empty.
    struct Listener {
        std::function<void(double fraction)> onProgress = {};
        std::function<void(const Result<ComparedMapsPtr>&)> onFinished = {};  ///< as of compareMaps()
        std::function<void(const std::string&)> onMessage = {};  ///< it could not be kept, and why
    };
    explicit MapComparing(Listener listener);
    ~MapComparing();  ///< cancels and waits for a step of the registration at most
    MapComparing(const MapComparing&) = delete;
    MapComparing& operator=(const MapComparing&) = delete;

    /// Compares, and keeps the result in the mission's folder.
    void begin(std::filesystem::path folder, ReviewIndexPtr index, RegistrationSettings settings);
    /// Tells what was kept, where something was: onFinished, or onMessage when it makes no sense any more.
    void recall(std::filesystem::path folder, ReviewIndexPtr index);
    void cancel();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
