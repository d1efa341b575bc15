#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// A found model point.
struct Neighbour {
    std::int32_t index = -1;  ///< position in the model's point list; -1: none within the bound
    float squaredDistance = std::numeric_limits<float>::infinity();  ///< [m^2]

    [[nodiscard]] bool found() const { return index >= 0; }
};

/// The methods of the paper's Table 1.
enum class SearchMethod : std::uint8_t { BruteForce, KdTree, Approximate, Forest };

/// Nearest-neighbour search over an unchanging model. Concurrent queries are safe.
class Search {
public:
    virtual ~Search() = default;

    /// Returns the model point nearest to @p query whose squared distance is below @p maxSquaredDistance
    /// [m^2]. Only Forest uses @p label: it searches the points with this label alone, also for Unlabelled.
    /// All points of a model without labels are unlabelled. The query must be finite.
    [[nodiscard]] virtual Neighbour nearest(const Eigen::Vector3f& query, Label label,
                                            float maxSquaredDistance) const = 0;
    /// Memory held in addition to the model cloud [bytes].
    [[nodiscard]] virtual std::size_t memory() const = 0;
};

/// Builds the search of @p method over @p model. @p epsilon: the (1 + epsilon) of Arya and Mount, used by
/// Approximate and Forest (0: exact). BruteForce refers to @p model, which must outlive it; the others copy.
[[nodiscard]] std::unique_ptr<Search> makeSearch(const PointCloud& model, SearchMethod method,
                                                 double epsilon = 0.0);

}  // namespace leitstand
