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

/// Removes other robots and passers-by from the scans. Used on the mapping's thread; passers-by are searched
/// in jobs of the solver.
class LeftOutBodies {
public:
    /// @p wake: makes the mapping's thread run once more; any thread.
    LeftOutBodies(MappingContext& context, MappedRobots& robots, std::function<void()> wake)
        : m_context(context), m_robots(robots), m_wake(std::move(wake)) {}

    /// Returns the bodies of other robots whose points may be in @p scan. @p only: the only robot to look
    /// for; empty: all robots.
    [[nodiscard]] std::vector<PlacedBody> in(const Scan& scan, const std::string& only = {});
    /// Removes each robot whose place has become certain from earlier scans, as long ago as odometry shows
    /// where it was. Returns whether the map has changed.
    bool leaveOutPlaced(Time now);
    void entered(std::uint64_t scan);  ///< adds a key scan in which passers-by shall be searched
    void lookForPassing();             ///< begins to search the next scan of entered() for passers-by

private:
    void leaveOutPassing(std::map<std::uint64_t, std::vector<BodyInScan>> found);
    /// Removes the robot @p name from scans that entered at @p since or later (station's clock; empty: all
    /// scans). Adds to @p found everything that is now removed from those scans.
    void leaveOut(const std::string& name, const std::optional<Time>& since,
                  std::map<std::uint64_t, std::vector<BodyInScan>>& found);
    /// Reports @p found: everything that is now removed from the scans in it.
    void publish(std::map<std::uint64_t, std::vector<BodyInScan>> found, Time now) const;

    /// When a robot's place was last certain.
    struct Sure {
        bool now = false;
        std::optional<Time> last;     ///< when, station's clock; empty: never
        std::optional<Pose> inFrame;  ///< pose of its odometry frame in the map at that time
    };

    MappingContext& m_context;
    MappedRobots& m_robots;
    const std::function<void()> m_wake;
    std::map<std::string, Sure> m_sure;    ///< by name
    std::vector<std::uint64_t> m_entered;  ///< key scans that were not searched for passers-by yet
    std::atomic<bool> m_looks = false;     ///< whether a key scan is being searched
    PassingBodies m_passing;               ///< used on the solver's thread
};

}  // namespace leitstand
