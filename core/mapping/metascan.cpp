#include "core/mapping/metascan.h"

#include "core/cloud/filters/voxel_grid.h"

namespace leitstand {

void Metascan::add(const PointCloud& cloud, const Pose& cloudInMap) {
    const Eigen::Isometry3f motion = cloudInMap.cast<float>();
    m_cloud.points.reserve(m_cloud.size() + cloud.size());
    for (const Eigen::Vector3f& point : cloud.points) m_cloud.points.push_back(motion * point);
    for (const Eigen::Vector3f& normal : cloud.normals) m_cloud.normals.push_back(motion.linear() * normal);
    m_cloud.labels.insert(m_cloud.labels.end(), cloud.labels.begin(), cloud.labels.end());
    m_cloud = voxelGrid(m_cloud, m_voxel);
}

}  // namespace leitstand
