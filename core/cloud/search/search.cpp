#include "core/cloud/search/search.h"

#include <array>

#include "core/cloud/search/kd_tree.h"

namespace leitstand {
namespace {

/// Measures the distance to every point (paper, Table 1, first row).
class BruteForceSearch final : public Search {
public:
    explicit BruteForceSearch(const PointCloud& model) : m_model(model) {}

    Neighbour nearest(const Eigen::Vector3f& query, Label /*label*/,
                      float maxSquaredDistance) const override {
        Neighbour best{-1, maxSquaredDistance};
        for (std::size_t i = 0; i < m_model.size(); ++i) {
            const float distance = detail::squaredDistance(query, m_model.points[i]);
            if (distance < best.squaredDistance) best = {static_cast<std::int32_t>(i), distance};
        }
        return best.found() ? best : Neighbour{};
    }

    std::size_t memory() const override { return 0; }

private:
    const PointCloud& m_model;
};

class KdTreeSearch final : public Search {
public:
    explicit KdTreeSearch(const PointCloud& model) : m_tree(model.points) {}

    Neighbour nearest(const Eigen::Vector3f& query, Label /*label*/,
                      float maxSquaredDistance) const override {
        return m_tree.nearest(query, maxSquaredDistance);
    }

    std::size_t memory() const override { return m_tree.memory(); }

private:
    KdTree m_tree;
};

class ApproximateSearch final : public Search {
public:
    ApproximateSearch(const PointCloud& model, double epsilon) : m_tree(model.points), m_epsilon(epsilon) {}

    Neighbour nearest(const Eigen::Vector3f& query, Label /*label*/,
                      float maxSquaredDistance) const override {
        return m_tree.nearestApproximate(query, m_epsilon, maxSquaredDistance);
    }

    std::size_t memory() const override { return m_tree.memory(); }

private:
    KdTree m_tree;
    double m_epsilon;
};

/// One tree a label (paper, section 2.2).
class ForestSearch final : public Search {
public:
    ForestSearch(const PointCloud& model, double epsilon) : m_epsilon(epsilon) {
        std::array<std::vector<std::int32_t>, LabelCount> chosen;
        for (std::size_t i = 0; i < model.size(); ++i) {
            const Label label = model.labels.empty() ? Label::Unlabelled : model.labels[i];
            chosen[static_cast<std::size_t>(label)].push_back(static_cast<std::int32_t>(i));
        }
        for (std::size_t i = 0; i < chosen.size(); ++i) m_trees[i] = KdTree(model.points, chosen[i]);
    }

    Neighbour nearest(const Eigen::Vector3f& query, Label label, float maxSquaredDistance) const override {
        const KdTree& tree = m_trees[static_cast<std::size_t>(label)];
        return tree.nearestApproximate(query, m_epsilon, maxSquaredDistance);
    }

    std::size_t memory() const override {
        std::size_t sum = 0;
        for (const KdTree& tree : m_trees) sum += tree.memory();
        return sum;
    }

private:
    std::array<KdTree, LabelCount> m_trees;
    double m_epsilon;
};

}  // namespace

std::unique_ptr<Search> makeSearch(const PointCloud& model, SearchMethod method, double epsilon) {
    switch (method) {
        case SearchMethod::BruteForce:
            return std::make_unique<BruteForceSearch>(model);
        case SearchMethod::KdTree:
            return std::make_unique<KdTreeSearch>(model);
        case SearchMethod::Approximate:
            return std::make_unique<ApproximateSearch>(model, epsilon);
        case SearchMethod::Forest:
            return std::make_unique<ForestSearch>(model, epsilon);
    }
    return nullptr;
}

}  // namespace leitstand
