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
        mission.publish(seconds, std::string(station_topic::KeyScans), *update.keyScan);
        if (links && update.links)
            mission.publish(seconds, std::string(station_topic::ScanLinks), *update.links);
        mission.publish(seconds, std::string(station_topic::ScanPoses), *update.poses);
        poses.push_back(update.poses->poses.front());
        seconds += 1.0;
    }
    return poses;
}

Pose driftedPlace(int place) {
    return poseFrom({-1.4 + 0.35 * place, 0.2, 0.9}, 0, 0, 0);
}

void writeDriftedRoom(WrittenMission& mission, double& seconds) {
    const Pose aside = poseFrom({0, 0.5, 0}, 0, 0, 0);
    const auto drifted = [](std::uint64_t scan) { return scan > DriftedFrom; };
    MappedRoom room;
    std::vector<ScanPose> poses;
    for (int place = 0; place < DriftedPlaces; ++place) {
        MapUpdate update = room.add(driftedPlace(place));
        mission.publish(seconds, std::string(station_topic::KeyScans), *update.keyScan);
        if (update.links) {
            std::erase_if(update.links->links,
                          [&](const Link& link) { return drifted(link.from) != drifted(link.to); });
            if (place == DriftedFrom) {
                Link odometry;
                odometry.id = 1'000;
                odometry.from = DriftedFrom;
                odometry.to = DriftedFrom + 1;
                odometry.pose = driftedPlace(place - 1).inverse() * aside * driftedPlace(place);
                odometry.kind = LinkKind::Odometry;
                odometry.station = "us";
                update.links->links.push_back(odometry);
            }
            mission.publish(seconds, std::string(station_topic::ScanLinks), *update.links);
        }
        poses.push_back(update.poses->poses.front());
        if (drifted(update.keyScan->id)) poses.back().scanInMap = aside * poses.back().scanInMap;
        mission.publish(
            seconds, std::string(station_topic::ScanPoses),
            ScanPosesSample{
                WrittenMission::at(seconds), "us", ScanPosesSample::Cause::Registration, {poses.back()}});
        seconds += 1.0;
    }
}

std::vector<Pose> alongTheRoom() {
    std::vector<Pose> places;
    for (int i = 0; i < 6; ++i)
        places.push_back(poseFrom({-1.4 + 0.4 * i, 0.05 * i, 0.9}, 0, 0, degrees(3) * i));
    return places;
}

}  // namespace leitstand::test
