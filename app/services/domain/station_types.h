#pragma once

#include <array>
#include <string_view>

#include "core/event/station_topics.h"

namespace leitstand {

/// A topic of the stations that has the same meaning in every log.
struct StationType {
    std::string_view topic, type;
    bool shared = false;  ///< whether MissionSharing publishes it and accepts it from other stations
};
inline constexpr std::array<StationType, 13> StationTypes = {{
    {station_topic::Grants, "leitstand_msgs/msg/Grant"},
    {station_topic::Victims, "leitstand_msgs/msg/Victim", true},
    {station_topic::Candidates, "leitstand_msgs/msg/Candidate", true},
    {station_topic::Mission, "leitstand_msgs/msg/MissionInfo", true},
    {station_topic::KeyScans, "leitstand_msgs/msg/KeyScan", true},
    {station_topic::ScanPoses, "leitstand_msgs/msg/ScanPoses", true},
    {station_topic::ScanLinks, "leitstand_msgs/msg/ScanLinks", true},
    {station_topic::ScanBodies, "leitstand_msgs/msg/ScanBodies", true},
    {station_topic::MapCrop, "leitstand_msgs/msg/MapCrop", true},
    {station_topic::RobotPlaces, "leitstand_msgs/msg/RobotPlace", true},
    {station_topic::Clock, "leitstand_msgs/msg/MissionClock", true},
    {station_topic::Notes, "leitstand_msgs/msg/Note"},
    {station_topic::Alarms, "leitstand_msgs/msg/Alarm"},
}};

}  // namespace leitstand
