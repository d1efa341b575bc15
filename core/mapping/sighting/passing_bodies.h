#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <Eigen/Core>

#include "core/event/map_samples.h"
#include "core/mapping/live/loops/free_spaces.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// How what passed by is told from what stays.
struct PassingSettings {
    FreeSpaceSettings looking = {
        .margin = 0.2F, .marginOfRange = 0.03F, .nearest = 0.5F, .beside = false, .rays = 2};
    double reach = 6.0;             ///< scans so near each other have a say in each other [m]
    std::size_t scans = 16;         ///< of those so many, the nearest
    double low = 0.15, high = 2.2;  ///< over the floor, of the points that are asked about [m]
    double edge = 0.1;              ///< of their grid: one point of each cell is asked about [m]
    int looksThrough = 3;           ///< so many scans at least looked through where a point is ...
    int oftener = 3;                ///< ... and so many times as many as saw something there
    int unseen = 2;                 ///< ... or only so many, where none saw anything: beside a robot few do
    double narrowest = 0.2,
           largest = 1.2;  ///< seen from above, of somebody who walks; else it is an edge, or a door [m]
    double tallest = 0.3;  ///< at least so much of its height was seen [m]
    int leastPoints =
        6;  ///< of the grid's, that passed beyond doubt: what hangs together with them did so, too
};

/// Finds what stood in scans while it passed by, people above all: other scans looked through where it was.
/// Each pair of scans near each other votes on the points of both (the free space of a map that scans carve:
/// Moravec & Elfes 1985; votes of scans on points: Pomerleau et al. 2014). What hangs together and is of a
/// person's size is a body, which is left out of its scan as another robot is; what is larger may be a door
/// that somebody shut. One thread at a time.
class PassingBodies {
public:
    /// What bodies are called that are left out so: BodyInScan::robot.
    static constexpr auto Name = "passing";

    explicit PassingBodies(const PassingSettings& settings = {})
        : m_settings(settings), m_voters(settings.looking, MostVoters) {}

    /// The key scan @p id of @p map has entered: what it and those near it say of each other, of @p together,
    /// which are nearly certain to lie right to each other, and which this run of the station has heard
    /// itself. Returns, of each scan of which they are noticeably others than before, all bodies.
    [[nodiscard]] std::map<std::uint64_t, std::vector<BodyInScan>> add(
        const LiveMap& map, std::uint64_t id, const std::set<std::uint64_t>& together);

private:
    static constexpr std::size_t MostVoters = 64;
    /// A point that is asked about.
    struct Asked {
        Eigen::Vector3f place;               ///< scan's frame [m]
        float height = 0.0F;                 ///< over the floor [m]
        std::uint8_t through = 0, seen = 0;  ///< votes
    };
    struct Looked {
        std::vector<Asked> asked;        ///< of the scan as it entered
        std::vector<BodyInScan> bodies;  ///< as they were returned
        std::uint64_t used = 0;          ///< when it was voted on last
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
    std::uint64_t m_votes = 0;  ///< so far: tells what was used last
};

}  // namespace leitstand
