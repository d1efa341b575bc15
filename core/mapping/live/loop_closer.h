#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mapping/graph/graph_solver.h"
#include "core/mapping/graph/scan_graph.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {

/// Finds where the way of robots meets itself, and brings the two ends together: what lies side by side in
/// the map and is far from each other over the graph is registered against each other; when two such places
/// agree, all poses follow.
class LoopCloser {
public:
    LoopCloser(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit);

    /// @p entered: a key scan of @p map that counts and is the newest of its robot; what it was registered
    /// against, with what the match came to. @p predecessor: the robot's key scan before; null: none. @p
    /// odometryScale: the way of the robot's odometry counts so many times.
    void add(const LiveKeyScan& entered, const LiveKeyScan* predecessor, const LiveMap& map,
             const std::vector<std::uint64_t>& matchedAgainst, const Match& match, double odometryScale);
    void forget(std::uint64_t id);

    /// Scans that are nearly certain to lie right to @p id.
    [[nodiscard]] std::map<std::uint64_t, double> sameAge(std::uint64_t id) const;

    /// Looks for a loop at the scan @p entered; the poses of all scans that move, where one closes.
    [[nodiscard]] std::vector<ScanPose> close(const LiveKeyScan& entered, const LiveMap& map);

    [[nodiscard]] const ScanGraph& graph() const { return m_graph; }
    [[nodiscard]] int closed() const { return m_closed; }  ///< loops

private:
    /// Two scans that see the same place, and by what the map's part about the later one would move.
    struct Found {
        Link link;
        Pose correction = Pose::Identity();  ///< to put before poses, in the map
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
    };
    [[nodiscard]] std::optional<Found> look(const LiveKeyScan& entered, const LiveMap& map);
    [[nodiscard]] bool agree(const Found& a, const Found& b) const;
    void take(const Found& found, const LiveMap& map);
    [[nodiscard]] std::vector<ScanPose> solved(const LiveMap& map) const;
    [[nodiscard]] Information informationOf(const IcpResult& icp, const Pose& toInMap) const;

    LoopSettings m_settings;
    MatchSettings m_match;
    FitSettings m_fit;
    ScanGraph m_graph;
    std::vector<Found> m_pending;
    int m_closed = 0;
};

}  // namespace leitstand
