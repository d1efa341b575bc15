#include "core/mapping/metascan.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace leitstand {
namespace {

constexpr std::size_t MostFresh = 16'000;  ///< points that are indexed again with each scan

/// Returns the points of @p cloud from @p first on.
PointCloud from(const PointCloud& cloud, std::size_t first) {
    const auto rest = [first](const auto& list) {
        using List = std::decay_t<decltype(list)>;
        return list.empty() ? List() : List(list.begin() + static_cast<std::ptrdiff_t>(first), list.end());
    };
    return {rest(cloud.points), rest(cloud.normals), rest(cloud.labels), {}};
}

}  // namespace

/// The older and the newer points of a metascan, each with a search of their own.
class Metascan::Parts : public Search {
public:
    explicit Parts(const MetascanSettings& settings) : m_settings(settings) {}

    /// Indexes @p cloud, which has grown.
    void follow(const PointCloud& cloud) {
        if (cloud.size() - settled() > MostFresh) index(m_old, cloud);
        index(m_fresh, from(cloud, settled()));
    }
    /// Number of the first points, which are not indexed again with each scan.
    [[nodiscard]] std::size_t settled() const { return m_old.cloud.size(); }
    [[nodiscard]] Neighbour nearest(const Eigen::Vector3f& query, Label label,
                                    float maxSquaredDistance) const override {
        Neighbour found;
        if (m_old.search) found = m_old.search->nearest(query, label, maxSquaredDistance);
        if (!m_fresh.search) return found;
        Neighbour newer =
            m_fresh.search->nearest(query, label, found.found() ? found.squaredDistance : maxSquaredDistance);
        if (!newer.found()) return found;
        newer.index += static_cast<std::int32_t>(settled());
        return newer;
    }
    [[nodiscard]] std::size_t memory() const override {
        std::size_t bytes = 0;
        for (const Part* part : {&m_old, &m_fresh}) {
            bytes += part->cloud.size() * (2 * sizeof(Eigen::Vector3f) + sizeof(Label));
            if (part->search) bytes += part->search->memory();
        }
        return bytes;
    }

private:
    struct Part {
        PointCloud cloud;  // a search may refer to it
        std::unique_ptr<Search> search;
    };
    void index(Part& part, PointCloud cloud) const {
        part.search.reset();
        part.cloud = std::move(cloud);
        if (!part.cloud.points.empty())
            part.search = makeSearch(part.cloud, m_settings.search, m_settings.epsilon);
    }

    MetascanSettings m_settings;
    Part m_old, m_fresh;
};

Metascan::Metascan(const MetascanSettings& settings)
    : m_cells(settings.voxel), m_parts(std::make_unique<Parts>(settings)) {}
Metascan::~Metascan() = default;

void Metascan::add(const PointCloud& cloud, const Pose& cloudInMap) {
    const Eigen::Isometry3f motion = cloudInMap.cast<float>();
    const bool normals = !cloud.normals.empty(), labels = !cloud.labels.empty();
    assert(m_cloud.points.empty() || cloud.points.empty() ||
           (normals == !m_cloud.normals.empty() && labels == !m_cloud.labels.empty()));
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3f point = motion * cloud.points[i];
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();
        if (normals) normal = motion.linear() * cloud.normals[i];
        const std::uint32_t cell = m_cells.cellOf(point);
        if (cell == detail::CellTable::Outside) continue;
        if (cell == m_sums.size()) {
            m_sums.emplace_back();
            m_cloud.points.push_back(point);
            if (normals) m_cloud.normals.push_back(normal);
            if (labels) m_cloud.labels.push_back(cloud.labels[i]);
        }
        if (cell < m_parts->settled()) continue;
        Sum& sum = m_sums[cell];
        sum.points += point.cast<double>();
        sum.normals += normal;
        sum.count += 1.0;
        m_cloud.points[cell] = (sum.points / sum.count).cast<float>();
        if (normals) m_cloud.normals[cell] = sum.normals.normalized();
    }
    m_parts->follow(m_cloud);
}

const Search& Metascan::search() const {
    return *m_parts;
}

}  // namespace leitstand
