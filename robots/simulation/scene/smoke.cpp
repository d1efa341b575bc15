#include "robots/simulation/scene/smoke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

Smoke::Smoke(const Arena& arena) {
    for (const Element& element : arena.elements) {
        if (element.kind != ElementKind::Smoke || !(element.reach > 0.0)) continue;
        const Eigen::Vector3f half = (element.size / 2).cast<float>();
        const auto height = static_cast<float>(element.size.z());
        m_boxes.push_back({element.pose.inverse().cast<float>(),
                           {-half.x(), -half.y(), 0.0F},
                           {half.x(), half.y(), height},
                           static_cast<float>(element.reach)});
    }
}

bool Smoke::swallows(const Ray& ray, float distance) const {
    float thickness = 0.0F;  // of smoke on the way; above 1 nothing is seen
    for (const Box& box : m_boxes) {
        const Eigen::Vector3f origin = box.arenaInBox * ray.origin;
        const Eigen::Vector3f direction = box.arenaInBox.linear() * ray.direction;
        float from = 0.0F, to = distance;  // slabs (Kay & Kajiya 1986)
        for (int axis = 0; axis < 3 && from < to; ++axis) {
            if (std::abs(direction[axis]) < 1e-9F) {
                if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) to = from;
                continue;
            }
            float near = (box.low[axis] - origin[axis]) / direction[axis];
            float far = (box.high[axis] - origin[axis]) / direction[axis];
            if (near > far) std::swap(near, far);
            from = std::max(from, near);
            to = std::min(to, far);
        }
        if (from < to) thickness += (to - from) / box.reach;
    }
    return thickness > 1.0F;
}

}  // namespace leitstand::simulation
