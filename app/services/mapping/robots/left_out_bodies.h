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

/// Leaves other robots, and who passes by, out of the scans. On the mapping's thread; passers-by are searched
/// for by jobs of the solver.
class LeftOutBodies {
public:
    /// @p wake: makes the mapping's thread go round once more; any thread.
    LeftOutBodies(MappingContext& context, MappedRobots& robots, std::function<void()> wake)
        : m_context(context), m_robots(robots), m_wake(std::move(wake)) {}

    /// Returns robots that @p scan, of another one, may have points of; of robot @p only if it is named.
    [[nodiscard]] std::vector<PlacedBody> in(const Scan& scan, const std::string& only = {});
    /// Leaves a robot whose place became certain out of scans from before, as far back as odometry shows
    /// where it was. Returns whether the map has changed.
    bool leaveOutPlaced(Time now);
    void entered(std::uint64_t scan);  ///< a key scan that is to be searched for passers-by
    void lookForPassing();             ///< searches the next of them

private:
    void leaveOutPassing(std::map<std::uint64_t, std::vector<BodyInScan>> found);
    /// Leaves robot @p name out of scans that entered @p since (station's clock; empty: ever). Adds to
    /// @p found what is left out of those scans now.
    void leaveOut(const std::string& name, const std::optional<Time>& since,
                  std::map<std::uint64_t, std::vector<BodyInScan>>& found);
    /// Reports what is left out of scans now.
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
    std::atomic<bool> m_looks = false;     ///< one of them is being searched
    PassingBodies m_passing;               ///< of the solver's thread
};

}  // namespace leitstand
