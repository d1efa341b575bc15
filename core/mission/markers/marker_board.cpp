#include "core/mission/markers/marker_board.h"

#include <algorithm>

namespace leitstand {
namespace {

std::size_t pointsOf(const MarkerBoard& board) {
    std::size_t points = 0;
    for (const auto& one : board.drawn) points += one.second.marker->points.size();
    return points;
}

bool isNear(const Eigen::Vector3d& place) {
    constexpr double Farthest = 1e6;  // [m]
    return place.allFinite() && place.cwiseAbs().maxCoeff() <= Farthest;
}

}  // namespace

bool isBounded(const MarkerBoard& board) {
    return board.drawn.size() <= MarkerBoard::MostMarkers && pointsOf(board) <= MarkerBoard::MostPoints;
}

bool isDrawable(const Marker& marker) {
    const auto isShare = [](float value) { return value >= 0.0F && value <= 1.0F; };
    const MarkerColour& colour = marker.colour;
    return isShare(colour.r) && isShare(colour.g) && isShare(colour.b) && isShare(colour.a) &&
           marker.markerInFrame.matrix().allFinite() && isNear(marker.markerInFrame.translation()) &&
           isNear(marker.size) && std::all_of(marker.points.begin(), marker.points.end(), isNear);
}

void MarkerBoard::take(const MarkersSample& sample, Time received, const Pose& baseInOdom) {
    if (sample.replacesAll) drawn.clear();
    std::erase_if(drawn, [&](const auto& one) { return isOver(one.second, received); });
    std::size_t points = pointsOf(*this);
    const auto remove = [&](auto one) {
        points -= one->second.marker->points.size();
        drawn.erase(one);
    };
    for (const Marker& marker : sample.markers) {
        const std::pair name(marker.space, marker.id);
        if (const auto before = drawn.find(name); before != drawn.end()) remove(before);
        if (marker.removed || marker.points.size() > MostPoints) continue;
        while (drawn.size() >= MostMarkers || points + marker.points.size() > MostPoints)
            remove(std::min_element(drawn.begin(), drawn.end(), [](const auto& a, const auto& b) {
                return a.second.received < b.second.received;
            }));
        points += marker.points.size();
        drawn.emplace(name, Drawn{received, baseInOdom, std::make_shared<const Marker>(marker)});
    }
}

}  // namespace leitstand
