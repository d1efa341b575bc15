#include "widgets/map_view/map_ruler.h"

#include <algorithm>

namespace leitstand {

void MapRuler::pick(const PickedPoint& picked, const SceneContent& content) {
    End end;
    end.inMap = picked.pointInMap;
    end.index = static_cast<std::size_t>(picked.scan);
    const SceneScan& scan = content.scans.at(end.index);
    end.id = scan.id;
    end.inScan = scan.poseInMap.inverse() * picked.pointInMap;
    const bool second = m_from && !m_to;
    (second ? m_to : m_from) = end;
    if (!second) m_to.reset();
}

void MapRuler::clear() {
    m_from.reset();
    m_to.reset();
}

std::optional<Eigen::Vector3d> MapRuler::from(const SceneContent& content) const {
    return placeOf(m_from, content);
}

std::optional<Eigen::Vector3d> MapRuler::to(const SceneContent& content) const {
    return placeOf(m_to, content);
}

std::optional<Measurement> MapRuler::measurement(const SceneContent& content) const {
    if (!m_from || !m_to) return std::nullopt;
    return Measurement{*from(content), *to(content)};
}

std::optional<Eigen::Vector3d> MapRuler::placeOf(const std::optional<End>& end, const SceneContent& content) {
    if (!end) return std::nullopt;
    const auto& scans = content.scans;
    const auto scan = end->id == 0
                          ? scans.begin() + static_cast<std::ptrdiff_t>(std::min(end->index, scans.size()))
                          : std::find_if(scans.begin(), scans.end(),
                                         [&](const SceneScan& one) { return one.id == end->id; });
    return scan == scans.end() ? end->inMap : Eigen::Vector3d(scan->poseInMap * end->inScan);
}

}  // namespace leitstand
