#pragma once

#include <bitset>
#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/time.h"

namespace leitstand {

struct CloudSample;
struct RobotDescription;

/// Settings of MappingScanner.
struct MappingScannerSettings {
    std::chrono::nanoseconds compare = std::chrono::seconds(3);  ///< how long clouds are compared
    /// How long it is waited for scanners that have sent nothing yet, since the first cloud.
    std::chrono::nanoseconds waitForAll = std::chrono::seconds(15);
    std::chrono::nanoseconds steady = std::chrono::seconds(1);  ///< longest gap between steady clouds
    double nearest = 0.5;     ///< points this near may be of the robot itself [m]
    double farEnough = 30.0;  ///< what is seen farther makes no difference [m]
};

/// Decides which 3D scanner of a robot makes the map. Scanners differ in place, rate and error: the scans of
/// two of them are never registered in one chain. Where no stream is named (StreamDescription::maps), clouds
/// are compared first: the scanner that sees most directions, and farthest in them, is chosen among those
/// that send steadily. Without clock and thread.
class MappingScanner {
public:
    explicit MappingScanner(const RobotDescription& robot, const MappingScannerSettings& settings = {});

    /// Takes a cloud of @p topic that was received at @p received. Returns whether it is of the scanner that
    /// makes the map; false while scanners are compared.
    [[nodiscard]] bool takes(const std::string& topic, const CloudSample& cloud, Time received);
    void choose(const std::string& topic) { m_chosen = topic; }
    /// Ends the comparison at @p now with what was seen so far.
    void decide(Time now);
    /// Returns the topic of the scanner that makes the map; empty: scanners are still compared, or there is
    /// none.
    [[nodiscard]] const std::string& chosen() const { return m_chosen; }
    [[nodiscard]] bool hasChoice() const { return m_topics.size() > 1; }  ///< the robot has several scanners

private:
    /// What one scanner's clouds showed so far.
    struct Seen {
        int clouds = 0;
        std::bitset<216> directions;     ///< on a cube about the scanner, 6 x 6 a side
        std::vector<double> reaches;     ///< of each cloud: nine of ten of its points are nearer [m]
        Time last{};                     ///< when its newest cloud was received
        std::chrono::nanoseconds gap{};  ///< longest time without one
    };
    void look(Seen& seen, const CloudSample& cloud, Time received) const;
    [[nodiscard]] double worth(const Seen& seen, Time now) const;

    MappingScannerSettings m_settings;
    std::vector<std::string> m_topics;
    std::string m_chosen;
    std::optional<Time> m_began;         ///< when the first cloud was received
    Time m_newcomer{};                   ///< when the first cloud of the last scanner was received
    std::map<std::string, Seen> m_seen;  ///< by topic
};

/// Returns the topic of the plane laser with which @p robot, one of @p team, makes the map. That is the one
/// that its file names (StreamDescription::maps). If no robot of the team has a 3D scanner, it is the first
/// plane laser of a robot that has odometry. Empty: its 3D scanner makes the map, or it is placed in the map
/// of others.
[[nodiscard]] std::string planeScanner(const RobotDescription& robot, std::span<const RobotDescription> team);

}  // namespace leitstand
