#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/mapping/robots/mapped_robots.h"
#include "core/event/scan_bodies.h"
#include "core/mapping/sighting/other_bodies.h"
#include "core/mapping/sighting/passing_bodies.h"

namespace leitstand {

/// Leaves other robots, and passers-by, out of the scans. On the mapping's thread; jobs of the solver search
/// for passers-by.
class LeftOutBodies {
public:
    /// @p wake: makes the mapping's thread go round once more; any thread.
    LeftOutBodies(MappingContext& context, MappedRobots& robots, std::function<void()> wake)
        : m_context(context), m_robots(robots), m_wake(std::move(wake)) {}

    /// Returns the bodies of other robots whose points may be in @p scan. @p only: the only robot to look
    /// for; empty: all.
    [[nodiscard]] std::vector<PlacedBody> in(const Scan& scan, const std::string& only = {});
    /// Leaves each robot whose place has become certain out of earlier scans, as far back as odometry shows
    /// where it was. Returns whether the map has changed.
    bool leaveOutPlaced(Time now);
    void entered(std::uint64_t scan);  ///< adds a key scan to be searched for passers-by
    void lookForPassing();             ///< begins to search the next of these scans

private:
    void leaveOutPassing(std::map<std::uint64_t, std::vector<BodyInScan>> found);
    /// Leaves robot @p name out of scans that entered at @p since or later (station's clock; empty: all
    /// scans). Adds to @p found all that is now left out of those scans.
    void leaveOut(const std::string& name, const std::optional<Time>& since,
                  std::map<std::uint64_t, std::vector<BodyInScan>>& found);
    /// Reports @p found: all that is now left out of the scans in it.
    void publish(std::map<std::uint64_t, std::vector<BodyInScan>> found, Time now) const;

    /// When a robot's place was certain.
    struct Sure {
        bool now = false;
        std::optional<Time> last;     ///< station's clock; empty: never
        std::optional<Pose> inFrame;  ///< where its odometry frame lay in the map then
    };

    MappingContext& m_context;
    MappedRobots& m_robots;
    const std::function<void()> m_wake;
    std::map<std::string, Sure> m_sure;    ///< by name
    std::vector<std::uint64_t> m_entered;  ///< key scans not searched for passers-by yet
    std::atomic<bool> m_looks = false;     ///< a key scan is being searched
    PassingBodies m_passing;               ///< of the solver's thread
};

}  // namespace leitstand
