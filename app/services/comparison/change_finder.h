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

/// The scans of @p map that count, for changesOf().
[[nodiscard]] std::vector<ReportScan> countingScans(const Map& map);

/// Finds what changed in a map since the missions before, on a thread of its own, which takes at most a fifth
/// of a core for a map that grows. Any thread.
class ChangeFinder {
public:
    ChangeFinder();
    ~ChangeFinder();
    ChangeFinder(const ChangeFinder&) = delete;
    ChangeFinder& operator=(const ChangeFinder&) = delete;

    /// Only the newest map counts; the one that was wanted last costs nothing. Null: none.
    void want(MapPtr map);
    /// Of the newest map that is done, which the one that is wanted goes on from; null where there is none.
    [[nodiscard]] MapChangesPtr changes() const;

private:
    void run(const std::stop_token& stop);

    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    MapPtr m_asked;                  ///< newest
    std::optional<MapPtr> m_wanted;  ///< and not begun
    MapChangesPtr m_changes;
    std::stop_source m_atWork;  ///< asked to stop once another map is wanted
    bool m_another = false;     ///< which is no continuation: nobody rests then
    std::jthread m_thread;      ///< last: joined first
};

}  // namespace leitstand
