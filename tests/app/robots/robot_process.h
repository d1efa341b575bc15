#pragma once

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/event/motion_samples.h"
#include "core/io/robot/robot_file.h"
#include "tests/support/child_process.h"
#include "tests/support/dds/robot_listener.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {

/// How many domains above the robots' the truth is told.
inline constexpr int TruthAbove = 100;

/// The robot's file that comes with the program.
[[nodiscard]] inline RobotDescription shippedRobot(const std::string& name) {
    return must(readRobot(sourceFolder() + "/resources/robots/" + name + ".yaml"));
}

/// leitstand-robot beside the test; there when constructed, else it throws what it said.
class RobotProcess {
public:
    RobotProcess(const TestDomain& domain, const std::string& kind, std::vector<std::string> more = {})
        : m_process(program("leitstand-robot"), arguments(domain, kind, std::move(more))) {
        const bool there = waitUntil([this] { return m_process.out().find(" is in ") != std::string::npos; },
                                     std::chrono::minutes(2));
        if (!there) throw std::runtime_error(kind + " did not come: " + m_process.out());
    }
    /// @p number is sent; returns the exit code, -1 when the signal ended it.
    int end(int number = SIGINT) {
        m_process.signal(number);
        return m_process.wait();
    }
    [[nodiscard]] std::string out() const { return m_process.out(); }
    [[nodiscard]] pid_t id() const { return m_process.id(); }

private:
    static std::vector<std::string> arguments(const TestDomain& domain, const std::string& kind,
                                              std::vector<std::string> more) {
        more.insert(more.begin(), {kind, "--domain", std::to_string(domain.number())});
        return more;
    }
    ChildProcess m_process;
};

/// What robots in an arena tell to be true.
class Truth {
public:
    /// @p arena: as a part of topics, "yellow_7".
    Truth(const TestDomain& domain, const std::string& arena, const std::string& robot = "kurt3d");

    [[nodiscard]] RobotListener& listener() { return *m_listener; }
    [[nodiscard]] const RobotListener& listener() const { return *m_listener; }
    [[nodiscard]] std::string topic(const std::string& leaf) const {
        return "/truth/" + m_arena + "/" + leaf;
    }
    /// Where the robot called @p name of that kind truly was; empty outside of what was heard.
    [[nodiscard]] std::optional<Pose> baseInArena(const std::string& kind, const std::string& name,
                                                  Time at) const;
    /// The newest that was heard.
    [[nodiscard]] std::optional<OdometrySample> newest(const std::string& kind,
                                                       const std::string& name) const;

private:
    std::string m_arena;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<RobotListener> m_listener;
};

/// Kurt3D at (-0.8, 0) and the Crawler at (0.8, 0) of a hall of 5 x 4 m, face to face, nothing between them;
/// a victim lies in a corner. @p name: the arena's.
[[nodiscard]] std::string hallFile(const std::string& name);

/// Where a mission's scans were registered to, against where they were truly taken.
struct Registered {
    int scans = 0;               ///< that the truth is known of
    double worstPosition = 0.0;  ///< [m]
    double worstTurn = 0.0;      ///< [rad]
    double travelled = 0.0;      ///< between the first and the farthest scan, truly [m]
    std::vector<std::string> problems;
};

/// Runs `leitstandctl register` on @p mission, whose only 3D scans are of @p robot. A last turn that the end
/// of the recording cut off is not held against the truth: half a turn may have seen no floor.
[[nodiscard]] Registered registerAgainst(const Truth& truth, const std::filesystem::path& mission,
                                         const RobotDescription& robot,
                                         const std::vector<std::string>& more = {});

}  // namespace leitstand::test
