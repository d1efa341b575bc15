#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "app/services/station/station.h"
#include "core/base/pose.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {

/// The operator of robots that look around by themselves, beside the station that is watched: it holds their
/// grants, asks each to explore again when it has done something else for a while, as one that waits before a
/// victim, and sends one that stands still, since nothing is left to explore, to where it was before; one
/// that is stuck is pulled back. It hears no more of them than that takes.
class ExploringDesk {
public:
    ExploringDesk(const TestDomain& domain, const std::vector<std::string>& robots);

    void look();  ///< to be called now and then
    [[nodiscard]] bool allExplore() const;
    [[nodiscard]] std::string doing() const;  ///< each robot's mode, reason and way, in words

private:
    using Time = std::chrono::steady_clock::time_point;
    struct Walk {
        std::string robot;
        std::vector<Pose> places = {};  ///< in odom, some way apart
        Pose here = Pose::Identity();   ///< where it moved last
        double length = 0.0;            ///< so far [m]
        double since = 0.0;             ///< of it, since it was sent somewhere [m]
        std::size_t tries = 0;          ///< places that it was sent to and did not go
        Time asked = {}, moved = {};
    };
    void sendOn(Walk& walk);
    void pullBack(const std::string& robot);
    static void follow(Walk& walk, const Pose& baseInOdom, Time now);

    const TemporaryFolder m_folder;
    std::vector<Walk> m_walks;
    std::unique_ptr<Station> m_station;
};

}  // namespace leitstand::test
