#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/mapping/comparison/map_changes.h"
#include "core/mapping/map.h"

namespace leitstand {

using MapChangesPtr = std::shared_ptr<const MapChanges>;

/// Returns the scans of @p map that count, for changesOf().
[[nodiscard]] std::vector<ReportScan> countingScans(const Map& map);

/// Finds what changed in a map since earlier missions, on its own thread. Uses at most a fifth of a core for
/// a growing map. Any thread.
class ChangeFinder {
public:
    ChangeFinder();
    ~ChangeFinder();
    ChangeFinder(const ChangeFinder&) = delete;
    ChangeFinder& operator=(const ChangeFinder&) = delete;

    /// Requests the changes of @p map. Only the newest map counts; requesting it again costs nothing. Null:
    /// no map.
    void want(MapPtr map);
    /// Returns the changes of the newest map that was searched. Null: none yet, or the map requested since
    /// has fewer scans.
    [[nodiscard]] MapChangesPtr changes() const;

private:
    void run(const std::stop_token& stop);

    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    MapPtr m_asked;                  ///< requested last
    std::optional<MapPtr> m_wanted;  ///< not begun yet
    MapChangesPtr m_changes;
    std::stop_source m_atWork;  ///< stop is requested once another map is wanted
    bool m_another =
        false;              ///< the wanted map does not continue the last one: it is searched without a pause
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
