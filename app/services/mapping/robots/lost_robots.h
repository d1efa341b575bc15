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

/// Looks in the map for robots that the operator asks for, and for those whose scans no longer fit. On the
/// mapping's thread; the search itself is a job of the solver.
class LostRobots {
public:
    LostRobots(MappingContext& context, MappedRobots& robots, RobotPlacing& placing);

    /// Looks for robot @p name by its newest 3D scan in the part of the map with its scans, for the operator.
    /// A robot with a certain place in a part that has not met the first one is looked for in the other
    /// parts. What is found there is a question to the operator.
    void lookFor(const std::string& name);
    /// Looks for robot @p name without a request if @p update shows that its scans no longer fit. When such
    /// searches fail for long, the robot goes on in a part of the map of its own.
    void seek(const std::string& name, const MapUpdate& update);
    void wasPut(
        const std::string& name);  ///< somebody placed the robot: results of searches under way are void

private:
    struct Lost {
        std::uint64_t put = 0;  ///< how often somebody set where it stands, or asked to look for it
        int scans = 0;          ///< its consecutive 3D scans that did not fit
        bool sought = false;    ///< a search without a request is under way
        int soughtAt = 0;       ///< value of `scans` when it began
        int vain = 0;           ///< consecutive searches without a request that found nothing
        /// The place that the last search without a request found: the next one has to agree.
        struct Find {
            Pose baseInMap, baseInOdom;
            int frame = 0;
        };
        std::optional<Find> find;
    };
    /// Whether somebody waits for the result.
    enum class Search : std::uint8_t { Asked, Unasked };
    /// Looks for @p name in @p part, the part of the map with its scans (0: the first part). The pose of that
    /// part relative to the others may be unknown.
    void lookInOwnPart(const std::string& name, std::uint64_t part, Search search);
    /// Looks for @p name, whose scans form their own part of the map, in the other parts.
    void lookElsewhere(const std::string& name);
    /// Takes the result @p found of a search for @p name with @p scan in @p map: the robot goes on from that
    /// place.
    void lookedFor(const std::string& name, const SeenScan& scan, const LiveMapPtr& map,
                   const Relocalisation& found, Search search);
    void lookedInVain(const std::string& name, std::size_t alike, Search search);
    /// Whether a find of @p name at @p baseInMap, by a scan that ended at @p end, agrees with the find before
    /// it and the odometry since then. Rooms look alike, paths through them less so.
    [[nodiscard]] bool findsAgree(const std::string& name, const Pose& baseInMap, Time end);

    MappingContext& m_context;
    MappedRobots& m_robots;
    RobotPlacing& m_placing;
    std::map<std::string, Lost> m_lost;  ///< by name; the set is fixed
};

}  // namespace leitstand
