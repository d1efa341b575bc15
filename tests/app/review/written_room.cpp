#include "tests/app/review/written_room.h"

#include <string>

#include "core/event/station_topics.h"

namespace leitstand::test {

std::vector<ScanPose> writeRoom(WrittenMission& mission, std::span<const Pose> places, double& seconds,
                                bool links) {
    MappedRoom room;
    std::vector<ScanPose> poses;
    for (const Pose& place : places) {
        const MapUpdate update = room.add(place);
        mission.say(seconds, std::string(station_topic::KeyScans), *update.keyScan);
        if (links && update.links) mission.say(seconds, std::string(station_topic::ScanLinks), *update.links);
        mission.say(seconds, std::string(station_topic::ScanPoses), *update.poses);
        poses.push_back(update.poses->poses.front());
        seconds += 1.0;
    }
    return poses;
}

std::vector<Pose> alongTheRoom() {
    std::vector<Pose> places;
    for (int i = 0; i < 6; ++i)
        places.push_back(poseFrom({-1.4 + 0.4 * i, 0.05 * i, 0.9}, 0, 0, degrees(3) * i));
    return places;
}

}  // namespace leitstand::test
