#include "tests/simulation/mapping/loop_score.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>

namespace leitstand::simulation::test {
namespace {

constexpr double Near = 1.5;     ///< two scans of one place [m]
constexpr double Apart = 20.0;   ///< along the way: else they hang together anyway [m]
constexpr double Within = 10.0;  ///< of way, a revisit is closed [m]
constexpr double Joined = 20.0;  ///< over so much of the graph scans hang together [m]
constexpr double Off = 0.3, OffAngle = degrees(3);

}  // namespace

LoopScore loopScore(const MappedDrive& mapped, const RecordedDrive& drive) {
    LoopScore score;
    const std::vector<LiveKeyScan>& keys = mapped.map->scans;
    std::vector<Pose> truth;
    std::vector<double> way;
    std::map<std::uint64_t, std::size_t> places;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        truth.push_back(drive.baseInArena(keys[i].scan->end) * keys[i].sensorInBase);
        way.push_back(i == 0 ? 0.0 : way.back() + distanceBetween(truth[i - 1], truth[i]));
        places[keys[i].id] = i;
    }
    ScanGraph graph = mapped.graph;  // with what is asked, where that is right
    for (const Link& link : mapped.graph.links()) {
        if (!closesLoop(link.kind)) continue;
        const Pose between = truth[places.at(link.from)].inverse() * truth[places.at(link.to)];
        const bool right =
            distanceBetween(between, link.pose) <= Off && angleBetween(between, link.pose) <= OffAngle;
        ++(link.active ? score.links : score.asked);
        if (!right) ++(link.active ? score.wrong : score.misled);
        if (!link.active && right) graph.setActive(link.id, true);
    }
    const auto earlier = [&](std::size_t i) -> std::optional<std::size_t> {
        std::optional<std::size_t> nearest;
        for (std::size_t j = 0; j < i && way[i] - way[j] > Apart; ++j) {
            const double distance = distanceBetween(truth[i], truth[j]);
            if (distance < (nearest ? distanceBetween(truth[i], truth[*nearest]) : Near)) nearest = j;
        }
        return nearest;
    };
    const auto joined = [&](std::size_t i) {
        const auto before = earlier(i);
        return before && graph.within(keys[i].id, Joined).contains(keys[*before].id);
    };
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (!earlier(i) || (i > 0 && earlier(i - 1))) continue;
        if (way.back() - way[i] < Within) continue;  // the drive ends before it has to be closed
        ++score.revisits;
        for (std::size_t k = i; k < keys.size() && way[k] - way[i] <= Within; ++k) {
            if (!joined(k)) continue;
            ++score.closed;
            break;
        }
    }
    return score;
}

}  // namespace leitstand::simulation::test
