#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "tests/app/review/written_mission.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {

/// Says into @p mission, from second @p seconds on, which rises, what a station said that mapped the room
/// from @p places of the sensor in it, and returns where it had its scans.
/// @p links: whether it said what each was registered against, as stations do from version 0.2 on.
std::vector<ScanPose> writeRoom(WrittenMission& mission, std::span<const Pose> places, double& seconds,
                                bool links = true);

/// Six places along the room, ahead and a little to the left.
[[nodiscard]] std::vector<Pose> alongTheRoom();

/// Where the sensor was at the places of writeDriftedRoom(), of which there are nine, in the room.
[[nodiscard]] Pose driftedPlace(int place);
inline constexpr int DriftedPlaces = 9, DriftedFrom = 4;
/// A map that drifted: from the fifth of its scans on all lie 0.5 m aside, as odometry had it.
void writeDriftedRoom(WrittenMission& mission, double& seconds);

}  // namespace leitstand::test
