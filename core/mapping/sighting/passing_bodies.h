#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <Eigen/Core>

#include "core/event/scan_bodies.h"
#include "core/mapping/live/loops/places/free_spaces.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// How something that passed by is distinguished from something that stays.
struct PassingSettings {
    FreeSpaceSettings looking = {
        .margin = 0.2F, .marginOfRange = 0.03F, .nearest = 0.5F, .beside = false, .rays = 2};
    double reach = 6.0;             ///< largest distance between scans that vote on each other [m]
    std::size_t scans = 16;         ///< largest number of scans that vote; the nearest ones are used
    double low = 0.15, high = 2.2;  ///< heights above the floor of the points that scans vote on [m]
    double edge = 0.1;              ///< edge of a grid cell [m]; scans vote on one point per cell
    int looksThrough = 3;  ///< a point has passed by if at least this many scans looked through its place ...
    int oftener = 3;       ///< ... and at least this many times as many as saw something there ...
    int unseen = 2;        ///< ... or, if no scan saw anything there (as beside a robot), at least this many
    /// Least and largest width of a walking person, seen from above [m]. Other things are edges or doors.
    double narrowest = 0.2, largest = 1.2;
    double tallest = 0.3;  ///< least height of the visible part of a body [m]
    /// Least number of points of a body that certainly passed. Points connected with them passed as well.
    int leastPoints = 6;
};

/// Finds what passed by while scans were taken, especially people: other scans looked through the place where
/// it was. Scans near each other vote on each other's points. Other methods carve the free space of a map
/// (Moravec & Elfes 1985); here scans vote on points (Pomerleau and others 2014). Connected points of the
/// size of a person are a body, which is removed from its scan like another robot. A larger thing may be a
/// door that somebody closed. One thread at a time.
class PassingBodies {
public:
    /// BodyInScan::robot of the bodies that are found here.
    static constexpr auto Name = "passing";

    explicit PassingBodies(const PassingSettings& settings = {})
        : m_settings(settings), m_voters(settings.looking, MostVoters) {}

    /// Lets the key scan @p id, which has entered @p map, and scans near it vote on each other. Only nearby
    /// scans in @p together vote, whose relative poses are nearly certain, and only those that were received
    /// since the station started. Returns all bodies of each scan whose bodies changed noticeably.
    [[nodiscard]] std::map<std::uint64_t, std::vector<BodyInScan>> add(
        const LiveMap& map, std::uint64_t id, const std::set<std::uint64_t>& together);

private:
    static constexpr std::size_t MostVoters = 64;
    /// A point that other scans vote on.
    struct Asked {
        Eigen::Vector3f place;  ///< place in the scan's frame [m]
        float height = 0.0F;    ///< height above the floor [m]
        /// Number of scans that looked through the place, and that saw something there.
        std::uint8_t through = 0, seen = 0;
    };
    struct Looked {
        std::vector<Asked> asked;        ///< points of the scan as it entered the map
        std::vector<BodyInScan> bodies;  ///< bodies as they were last returned
        std::uint64_t used = 0;          ///< number of the last vote on this scan
    };
    Looked& lookedAt(const LiveKeyScan& scan);
    void vote(const LiveKeyScan& by, const LiveKeyScan& on);
    [[nodiscard]] std::vector<BodyInScan> bodiesOf(const LiveKeyScan& scan, const Looked& looked) const;
    [[nodiscard]] bool passed(const Asked& one) const {
        const int least = one.seen == 0 ? m_settings.unseen : m_settings.looksThrough;
        return one.through >= least && one.through >= m_settings.oftener * one.seen;
    }

    PassingSettings m_settings;
    std::map<std::uint64_t, Looked> m_looked;  ///< by id of the key scan
    FreeSpaces m_voters;
    std::uint64_t m_votes = 0;  ///< number of votes so far; Looked::used refers to it
};

}  // namespace leitstand
