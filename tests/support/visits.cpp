#include "tests/support/visits.h"

#include <chrono>
#include <memory>
#include <utility>

#include "tests/support/rooms.h"

namespace leitstand::test {

std::vector<ReportScan> scansOf(const RoomVisit& visit) {
    std::vector<ReportScan> scans;
    for (int i = 0; i < visit.scans; ++i) {
        const std::uint64_t id = visit.first + static_cast<std::uint64_t>(i);
        RoomSettings room;
        room.furnished = visit.furnished;
        room.sensorInRoom = poseFrom({-0.5 + 0.4 * i, 0.0, 0.9}, 0, 0, 0);
        room.sweep = Sweep::Yawing;
        room.rows = 361;
        room.columns = 161;
        room.seed = static_cast<unsigned>(id);
        RoomScan seen = scanRoom(room);
        auto scan = std::make_shared<Scan>(std::move(seen.scan));
        scan->labels = std::move(seen.trueLabels);
        scan->robot = visit.robot;
        scan->end = Time(std::chrono::hours(24 * visit.day) + std::chrono::seconds(1000 + id));
        scans.push_back({.id = id, .scan = std::move(scan), .scanInMap = room.sensorInRoom});
    }
    return scans;
}

}  // namespace leitstand::test
