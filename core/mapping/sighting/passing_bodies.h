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

/// How something that passed by is distinguished from what stays.
struct PassingSettings {
    FreeSpaceSettings looking = {
        .margin = 0.2F, .marginOfRange = 0.03F, .nearest = 0.5F, .beside = false, .rays = 2};
    double reach = 6.0;             ///< largest distance between scans that vote on each other [m]
    std::size_t scans = 16;         ///< largest number of scans that vote; the nearest are taken
    double low = 0.15, high = 2.2;  ///< heights over the floor of the points that are voted on [m]
    double edge = 0.1;              ///< edge of a grid cell; one point of each cell is voted on [m]
    int looksThrough = 3;  ///< least number of scans that looked through where a passing point is ...
    int oftener = 3;       ///< ... and how many times as many as saw something there, at least ...
    int unseen = 2;        ///< ... or least number where no scan saw anything, as beside a robot
    /// Least and largest width of a person who walks, seen from above; others are edges, or doors [m].
    double narrowest = 0.2, largest = 1.2;
    double tallest = 0.3;  ///< least height of the visible part of a body [m]
    /// Least number of a body's points that passed beyond doubt. Points connected with these passed as well.
    int leastPoints = 6;
};

/// Finds what passed by while scans were taken, people above all: other scans looked through where it was.
/// Each pair of scans near each other votes on the points of both. Scans carve the free space of a map
/// (Moravec & Elfes 1985); scans vote on points (Pomerleau and others 2014). Connected points of a person's
/// size are a body, which is left out of its scan as another robot is. A larger thing may be a door that
/// somebody shut. One thread at a time.
class PassingBodies {
public:
    /// BodyInScan::robot of the bodies that are left out.
    static constexpr auto Name = "passing";

    explicit PassingBodies(const PassingSettings& settings = {})
        : m_settings(settings), m_voters(settings.looking, MostVoters) {}

    /// Lets the key scan @p id, which has entered @p map, and scans near it vote on each other. Of the scans
    /// nearby, only those of @p together (with nearly certain relative poses) vote, and only those that this
    /// run of the station received itself. Returns all bodies of each scan whose bodies changed noticeably.
    [[nodiscard]] std::map<std::uint64_t, std::vector<BodyInScan>> add(
        const LiveMap& map, std::uint64_t id, const std::set<std::uint64_t>& together);

private:
    static constexpr std::size_t MostVoters = 64;
    /// A point that is voted on.
    struct Asked {
        Eigen::Vector3f place;               ///< scan's frame [m]
        float height = 0.0F;                 ///< over the floor [m]
        std::uint8_t through = 0, seen = 0;  ///< votes
    };
    struct Looked {
        std::vector<Asked> asked;        ///< points of the scan as it entered
        std::vector<BodyInScan> bodies;  ///< as they were returned
        std::uint64_t used = 0;          ///< number of the last vote on it
    };
    Looked& lookedAt(const LiveKeyScan& scan);
    void vote(const LiveKeyScan& by, const LiveKeyScan& on);
    [[nodiscard]] std::vector<BodyInScan> bodiesOf(const LiveKeyScan& scan, const Looked& looked) const;
    [[nodiscard]] bool passed(const Asked& one) const {
        const int least = one.seen == 0 ? m_settings.unseen : m_settings.looksThrough;
        return one.through >= least && one.through >= m_settings.oftener * one.seen;
    }

    PassingSettings m_settings;
    std::map<std::uint64_t, Looked> m_looked;  ///< by key scan
    FreeSpaces m_voters;
    std::uint64_t m_votes = 0;  ///< so far; Looked::used counts in these
};

}  // namespace leitstand
