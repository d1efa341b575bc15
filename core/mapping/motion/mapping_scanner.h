#pragma once

#include <bitset>
#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace leitstand {

struct CloudSample;
struct RobotDescription;

/// Settings of MappingScanner.
struct MappingScannerSettings {
    /// How long clouds are compared before a scanner is chosen.
    std::chrono::nanoseconds compare = std::chrono::seconds(3);
    /// How long to wait after the first cloud for scanners that have sent nothing yet.
    std::chrono::nanoseconds waitForAll = std::chrono::seconds(15);
    /// Longest gap between clouds of a scanner that sends steadily.
    std::chrono::nanoseconds steady = std::chrono::seconds(1);
    double nearest = 0.5;     ///< nearer points may belong to the robot itself [m]
    double farEnough = 30.0;  ///< larger ranges make no difference [m]
};

/// Decides which scanner of a robot makes the map, for robots that send clouds: one of them, or a plane laser
/// that sees more, as beside a depth camera. Scanners differ in place, rate and error, so scans of two
/// scanners are never registered in one chain. A plane laser is compared only with clouds that come. If no
/// stream is named (StreamDescription::maps), clouds are compared first. Of the scanners that send steadily,
/// the one is chosen that sees most directions, and farthest in them. It has no clock and no thread.
class MappingScanner {
public:
    explicit MappingScanner(const RobotDescription& robot, const MappingScannerSettings& settings = {});

    /// Takes a cloud of @p topic, or a plane laser's turn as cloudOf(), that was received at @p received.
    /// Returns whether it comes from the scanner that makes the map; false while scanners are compared.
    [[nodiscard]] bool takes(const std::string& topic, const CloudSample& cloud, Time received);
    [[nodiscard]] bool compares() const { return !m_topics.empty(); }  ///< whether the robot has clouds
    /// Whether @p topic is of one of the scanners.
    [[nodiscard]] bool compares(const std::string& topic) const;
    void choose(const std::string& topic) { m_chosen = topic; }
    /// Ends the comparison at @p now, and decides by the clouds so far.
    void decide(Time now);
    /// Returns the topic of the scanner that makes the map. Empty: scanners are still compared, or there is
    /// none.
    [[nodiscard]] const std::string& chosen() const { return m_chosen; }
    /// Whether the robot has several scanners.
    [[nodiscard]] bool hasChoice() const { return m_topics.size() > 1; }

private:
    /// What the clouds of one scanner have shown so far.
    struct Seen {
        int clouds = 0;
        /// Directions in which it sees, on a cube around it with 6 x 6 cells per side.
        std::bitset<216> directions;
        std::vector<double> reaches;     ///< range of each cloud within which nine of ten points are [m]
        Time last{};                     ///< when its newest cloud was received
        std::chrono::nanoseconds gap{};  ///< longest time between two clouds
    };
    void look(Seen& seen, const CloudSample& cloud, Time received) const;
    [[nodiscard]] bool isCloud(const std::string& topic) const;
    /// Returns the best of the scanners from number @p first to before @p last, with its worth; no topic:
    /// none has sent anything.
    [[nodiscard]] std::pair<std::string, double> best(std::size_t first, std::size_t last, Time now) const;
    /// Returns how much a scanner sees. @p now: less if it is unsteady then; empty: whether or not it is.
    [[nodiscard]] double worth(const Seen& seen, std::optional<Time> now) const;

    MappingScannerSettings m_settings;
    std::vector<std::string> m_topics;  ///< of clouds first, then of plane lasers
    std::size_t m_clouds = 0;           ///< number of clouds among the topics
    std::string m_chosen;
    std::optional<Time> m_began;         ///< when the first cloud was received
    Time m_newcomer{};                   ///< when the newest scanner sent its first cloud
    std::map<std::string, Seen> m_seen;  ///< by topic
};

/// Returns the topic of the plane laser with which @p robot can make the map. It is the one that its file
/// names (StreamDescription::maps), or else the first one of a robot that has odometry. Empty: there is none.
[[nodiscard]] std::string planeLaserOf(const RobotDescription& robot);

/// Returns the topic of the plane laser with which @p robot, one of @p team, makes the map. That is the one
/// that its file names (StreamDescription::maps). If no robot of the team has a 3D scanner, it is the first
/// plane laser of a robot that has odometry. Empty: its 3D scanner makes the map, or it is placed in the map
/// of others.
[[nodiscard]] std::string planeScanner(const RobotDescription& robot, std::span<const RobotDescription> team);

}  // namespace leitstand
