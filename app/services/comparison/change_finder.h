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

/// Returns the certain scans of @p map, for changesOf().
[[nodiscard]] std::vector<ReportScan> countingScans(const Map& map);

/// Finds what has changed in a map since earlier missions, on its own thread. Uses at most a fifth of a core
/// while the map grows. Any thread.
class ChangeFinder {
public:
    ChangeFinder();
    ~ChangeFinder();
    ChangeFinder(const ChangeFinder&) = delete;
    ChangeFinder& operator=(const ChangeFinder&) = delete;

    /// Requests the changes of @p map. Only the newest requested map is searched; requesting it again costs
    /// nothing. Null: no map.
    void want(MapPtr map);
    /// Returns the changes of the newest map that was searched. Null: there are none yet, or a map with fewer
    /// scans was requested since then.
    [[nodiscard]] MapChangesPtr changes() const;

private:
    void run(const std::stop_token& stop);

    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    MapPtr m_asked;                  ///< map that was requested last
    std::optional<MapPtr> m_wanted;  ///< requested map whose search has not begun
    MapChangesPtr m_changes;
    std::stop_source m_atWork;  ///< stopped when another map is requested
    bool m_another = false;     ///< the new map does not continue the last one: search without pauses
    std::jthread m_thread;      ///< the last member, so that it is joined first
};

}  // namespace leitstand
