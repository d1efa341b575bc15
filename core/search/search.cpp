#include "core/search/search.h"

namespace leitstand {
namespace {

/// Measures the distance to every point (paper, Table 1, first row).
class BruteForceSearch final : public Search {
public:
    BruteForceSearch(const PointCloud& model, bool byLabel)
        : m_model(model), m_byLabel(byLabel && !model.labels.empty()) {}

    Neighbour nearest(const Eigen::Vector3f& query, Label label, float maxSquaredDistance) const override {
        Neighbour best{-1, maxSquaredDistance};
        for (std::size_t i = 0; i < m_model.size(); ++i) {
            if (m_byLabel && m_model.labels[i] != label) continue;
            const float distance = (query - m_model.points[i]).squaredNorm();
            if (distance < best.squaredDistance) best = {static_cast<std::int32_t>(i), distance};
        }
        return best.found() ? best : Neighbour{};
    }

    std::size_t memory() const override { return 0; }

private:
    const PointCloud& m_model;
    bool m_byLabel;
};

}  // namespace

std::unique_ptr<Search> makeSearch(const PointCloud& model, SearchMethod method, double /*epsilon*/) {
    return std::make_unique<BruteForceSearch>(model, method == SearchMethod::Forest);
}

}  // namespace leitstand
