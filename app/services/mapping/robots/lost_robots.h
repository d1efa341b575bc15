#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "app/services/mapping/robots/mapped_robots.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

class RobotPlacing;

/// Looks in the map for robots that the operator asks for, and for robots whose scans no longer fit. Used on
/// the mapping's thread; the search itself is a job of the solver.
class LostRobots {
public:
    LostRobots(MappingContext& context, MappedRobots& robots, RobotPlacing& placing);

    /// Looks for the robot @p name by its newest 3D scan, in the part of the map that has its scans, because
    /// the operator asked for it. If the robot has a certain place in a part that is not joined with the
    /// first one, it is looked for in the other parts. What is found there is a question to the operator.
    void lookFor(const std::string& name);
    /// If @p update shows that the scans of robot @p name no longer fit, looks for it without a request. If
    /// such searches fail for long, the robot continues in a new part of the map.
    void seek(const std::string& name, const MapUpdate& update);
    /// Call when somebody placed the robot: results of running searches are ignored.
    void wasPut(const std::string& name);

private:
    struct Lost {
        std::uint64_t put = 0;  ///< how often somebody placed it, or asked to look for it
        int scans = 0;          ///< number of consecutive 3D scans that did not fit
        bool sought = false;    ///< whether a search without a request is running
        int soughtAt = 0;       ///< value of `scans` when that search began
        int vain = 0;           ///< number of consecutive searches without a request that found nothing
        /// The place that the last search without a request found. The next place must agree with it.
        struct Find {
            Pose baseInMap, baseInOdom;
            int frame = 0;
        };
        std::optional<Find> find;
    };
    /// Whether somebody waits for the result.
    enum class Search : std::uint8_t { Asked, Unasked };
    /// Looks for @p name in @p part, the part of the map that has its scans (0: the first part). The pose of
    /// that part relative to others may be unknown.
    void lookInOwnPart(const std::string& name, std::uint64_t part, Search search);
    /// Looks for @p name, whose scans form a separate part of the map, in the other parts.
    void lookElsewhere(const std::string& name);
    /// Takes the result @p found of a search for @p name with @p scan in @p map. The robot continues from
    /// that place.
    void lookedFor(const std::string& name, const SeenScan& scan, const LiveMapPtr& map,
                   const Relocalisation& found, Search search);
    void lookedInVain(const std::string& name, std::size_t alike, Search search);
    /// Whether @p name was found at @p baseInMap, by a scan that ended at @p end, in agreement with the place
    /// found before and the odometry since then. Rooms look alike; paths through them less often do.
    [[nodiscard]] bool findsAgree(const std::string& name, const Pose& baseInMap, Time end);

    MappingContext& m_context;
    MappedRobots& m_robots;
    RobotPlacing& m_placing;
    std::map<std::string, Lost> m_lost;  ///< by name; robots are never added or removed
};

}  // namespace leitstand
