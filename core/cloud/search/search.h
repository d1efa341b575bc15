#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// A found model point.
struct Neighbour {
    std::int32_t index = -1;  ///< index in the model's list of points; -1: none within the bound
    float squaredDistance = std::numeric_limits<float>::infinity();  ///< [m^2]

    [[nodiscard]] bool found() const { return index >= 0; }
};

/// The methods of the paper's Table 1.
enum class SearchMethod : std::uint8_t { BruteForce, KdTree, Approximate, Forest };

/// Nearest-neighbour search in a model that does not change. Concurrent queries are safe.
class Search {
public:
    virtual ~Search() = default;

    /// Returns the model point nearest to @p query whose squared distance is below @p maxSquaredDistance
    /// [m^2]. Only Forest uses @p label: it searches only points with this label, even if that is Unlabelled.
    /// If a model has no labels, all its points are unlabelled. The query must be finite.
    [[nodiscard]] virtual Neighbour nearest(const Eigen::Vector3f& query, Label label,
                                            float maxSquaredDistance) const = 0;
    /// Memory used in addition to the model cloud [B].
    [[nodiscard]] virtual std::size_t memory() const = 0;
};

/// Builds the search with @p method in @p model. @p epsilon: used by Approximate and Forest as in Arya and
/// Mount's (1 + epsilon); 0: exact. BruteForce refers to @p model, which must outlive it; the others copy it.
[[nodiscard]] std::unique_ptr<Search> makeSearch(const PointCloud& model, SearchMethod method,
                                                 double epsilon = 0.0);

}  // namespace leitstand
