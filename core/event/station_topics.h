#pragma once

#include <string_view>

namespace leitstand {

/// Topics of the stations' own events: reliable, transient local (docs/design.md, "The wire"). The comment
/// after each topic is its type in leitstand_msgs/msg/.
namespace station_topic {

inline constexpr std::string_view Prefix = "/leitstand/";
inline constexpr std::string_view Grants = "/leitstand/grants";               ///< Grant
inline constexpr std::string_view Victims = "/leitstand/victims";             ///< Victim
inline constexpr std::string_view Candidates = "/leitstand/candidates";       ///< Candidate
inline constexpr std::string_view KeyScans = "/leitstand/key_scans";          ///< KeyScan
inline constexpr std::string_view ScanPoses = "/leitstand/scan_poses";        ///< ScanPoses
inline constexpr std::string_view ScanLinks = "/leitstand/scan_links";        ///< ScanLinks
inline constexpr std::string_view ScanBodies = "/leitstand/scan_bodies";      ///< ScanBodies
inline constexpr std::string_view MapCrop = "/leitstand/map_crop";            ///< MapCrop
inline constexpr std::string_view RobotPlaces = "/leitstand/robot_places";    ///< RobotPlace
inline constexpr std::string_view Clock = "/leitstand/clock";                 ///< MissionClock
inline constexpr std::string_view ClockOffsets = "/leitstand/clock_offsets";  ///< ClockOffset
inline constexpr std::string_view Undo = "/leitstand/undo";                   ///< Undo
inline constexpr std::string_view Checkpoints = "/leitstand/checkpoints";     ///< Checkpoint
inline constexpr std::string_view Notes = "/leitstand/notes";                 ///< Note
inline constexpr std::string_view Mission = "/leitstand/mission";             ///< MissionInfo
inline constexpr std::string_view Sessions = "/leitstand/sessions";           ///< Session
inline constexpr std::string_view Alarms = "/leitstand/alarms";               ///< Alarm

/// Whether events on @p topic are actions of a person. They are few and small, and the last to be dropped.
[[nodiscard]] constexpr bool isByHand(std::string_view topic) {
    return topic == Grants || topic == Victims || topic == MapCrop || topic == RobotPlaces ||
           topic == Clock || topic == Undo || topic == Notes || topic == Mission;
}

}  // namespace station_topic
}  // namespace leitstand
