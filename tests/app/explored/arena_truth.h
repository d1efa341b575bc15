#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/pose_track.h"
#include "tests/support/dds/test_domain.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// Where robots of an arena truly are and were, as their processes tell for as long as this lives.
class ArenaTruth {
public:
    /// @p arena: as a part of topics, "yellow_7"; @p robots: by kind and name, which are the same.
    ArenaTruth(const TestDomain& domain, const std::string& arena, const std::vector<std::string>& robots);
    ~ArenaTruth();
    ArenaTruth(const ArenaTruth&) = delete;
    ArenaTruth& operator=(const ArenaTruth&) = delete;

    [[nodiscard]] std::optional<Pose> newest(const std::string& robot) const;  ///< base_link in the arena
    [[nodiscard]] std::optional<Pose> at(const std::string& robot, Time stamp) const;  ///< robot's clock
    [[nodiscard]] double way(const std::string& robot) const;                          ///< that it drove [m]

private:
    struct Track {
        std::optional<Pose> newest;
        PoseTrack track;
        double way = 0.0;
    };
    mutable std::mutex m_mutex;
    std::map<std::string, Track> m_tracks;
    std::unique_ptr<Node> m_node;
    std::vector<std::unique_ptr<Subscription>> m_subscriptions;
};

}  // namespace leitstand::test
