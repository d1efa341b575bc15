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

/// Looks for robots in the whole map: those that the operator asks for, and those whose scans no longer fit.
/// On the mapping's thread; the search itself is a job of the solver.
class LostRobots {
public:
    LostRobots(MappingContext& context, MappedRobots& robots, RobotPlacing& placing);

    /// Looks for robot @p name by its newest 3D scan, for the operator.
    void lookFor(const std::string& name);
    /// Looks unasked for a robot whose scans no longer fit, by @p update. When that fails for long, the robot
    /// goes on in its own part of the map.
    void seek(const std::string& name, const MapUpdate& update);
    void wasPut(const std::string& name);  ///< somebody set where it stands: results on their way are void

private:
    struct Lost {
        std::uint64_t put = 0;  ///< how often somebody set where it stands, or asked to look for it
        int scans = 0;          ///< its consecutive 3D scans that did not fit
        bool sought = false;    ///< it is being looked for unasked ...
        int soughtAt = 0;       ///< ... since so many of them
        int vain = 0;           ///< consecutive unasked searches that found nothing
        /// Where an unasked search found it once: another find has to agree.
        struct Find {
            Pose baseInMap, baseInOdom;
            int frame = 0;
        };
        std::optional<Find> find;
    };
    /// Whether somebody waits for the result.
    enum class Search : std::uint8_t { Asked, Unasked };
    /// Looks for @p name in @p part of the map: the part with its scans, whose place relative to others may
    /// be unknown.
    void lookInOwnPart(const std::string& name, std::uint64_t part, Search search);
    /// Looks for @p name, whose scans form their own part of the map, in the other parts.
    void lookElsewhere(const std::string& name);
    /// Takes the result of a search for @p name with @p scan in @p map: goes on from where it was found.
    void lookedFor(const std::string& name, const SeenScan& scan, const LiveMapPtr& map,
                   const Relocalisation& found, Search search);
    void lookedInVain(const std::string& name, std::size_t alike, Search search);
    /// Whether an unasked find of @p name at @p baseInMap, by a scan that ended at @p end, agrees with an
    /// earlier find and the odometry since. Rooms look alike, paths through them less so.
    [[nodiscard]] bool findsAgree(const std::string& name, const Pose& baseInMap, Time end);

    MappingContext& m_context;
    MappedRobots& m_robots;
    RobotPlacing& m_placing;
    std::map<std::string, Lost> m_lost;  ///< by name; the set is fixed
};

}  // namespace leitstand
