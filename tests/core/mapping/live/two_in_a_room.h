#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mapping/live/live_mapper.h"
#include "core/mapping/relocalisation/place_recognition.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {

/// In a room there is little way on which places can agree.
inline LiveSettings inARoom() {
    LiveSettings settings;
    settings.loops.seekPartsEvery = 0.3;
    return settings;
}

/// A room that one robot has mapped, and another one that nobody has placed in it.
struct TwoRobotsInARoom : MappedRoom {
    explicit TwoRobotsInARoom(const LiveSettings& settings = inARoom()) : MappedRoom(settings) { drive(6); }

    /// What the second robot sees from @p sensorInRoom; its odometry has a frame of its own.
    LiveScan seen(const Pose& sensorInRoom) {
        LiveScan live = scanAt(sensorInRoom, seed++);
        Scan scan = *live.scan;
        scan.robot = "second";
        scan.sensorInOdom = poseFrom({3, 1, 0}, 0, 0, degrees(70)) * scan.sensorInOdom;
        live.scan = std::make_shared<const Scan>(std::move(scan));
        return live;
    }
    /// It goes across the room and turns a little; what is sought is found where it can be.
    std::optional<ScanLinksSample> explore(int scans) {
        std::optional<ScanLinksSample> question;
        for (int i = 0; i < scans && !question; ++i) {
            const Pose here = poseFrom({1.5 - 0.45 * i, 1.0 - 0.3 * i, 0.9}, 0, 0, degrees(200 + 4 * i));
            const MapUpdate update = add(seen(here));
            if (update.keyScan) second.emplace_back(update.keyScan->id, here);
            if (update.loop && !update.loop->links.front().active) question = update.loop;
            const auto sought = mapper.sought();
            const auto place = sought ? recognise(*sought, {}) : std::nullopt;
            if (place) question = mapper.recognised(*sought, *place, now);
            if (question) log.publish(*question, "/leitstand/scan_links");
        }
        return question;
    }
    /// What the operator says to @p question.
    void answer(ScanLinksSample question, bool same) {
        for (Link& link : question.links) {
            link.kind = LinkKind::Operator;
            link.active = same;
        }
        log.publish(question, "/leitstand/scan_links");
        mapper.restore(question);
    }
    /// How far the second robot's scans are from where they were taken, in the first one's map [m].
    double worst() {
        const LiveMapPtr map = mapper.map();
        const Pose roomInMap =
            map->scans.front().pose.scanInMap * poseFrom({-1.4, 0, 0.9}, 0, 0, 0).inverse();
        double largest = 0.0;
        for (const auto& [id, inRoom] : second) {
            for (const LiveKeyScan& scan : map->scans) {
                if (scan.id == id)
                    largest = std::max(largest, distanceBetween(scan.pose.scanInMap, roomInMap * inRoom));
            }
        }
        return largest;
    }
    std::vector<LiveKeyScan> scansOf(const std::string& robot) {
        std::vector<LiveKeyScan> found;
        const LiveMapPtr map = mapper.map();
        for (const LiveKeyScan& scan : map->scans) {
            if (scan.scan->robot == robot) found.push_back(scan);
        }
        return found;
    }

    std::vector<std::pair<std::uint64_t, Pose>> second;  ///< ids, and where they were taken
};

}  // namespace leitstand::test
