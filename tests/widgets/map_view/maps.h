#pragma once

#include <vector>

#include "core/mapping/map.h"

namespace leitstand::test {

/// A generated room seen from two places, its labels the true ones. The guess of the second scan is half a
/// metre and ten degrees off.
[[nodiscard]] MapPtr roomMap();

/// A map of one scan at the origin, unorganised.
[[nodiscard]] MapPtr mapOf(std::vector<Eigen::Vector3f> points, Label label = Label::Wall);

/// A scan of a blob: points within 5 cm of @p centre [m].
[[nodiscard]] ScanPtr blob(const Eigen::Vector3f& centre, Label label);

/// A map of these scans, all of them at the origin, before registration too.
[[nodiscard]] MapPtr mapOf(const std::vector<ScanPtr>& scans);

/// @p count points of a generated room in scans of 50,000; made once for each count.
[[nodiscard]] MapPtr largeMap(std::size_t count, std::size_t scanSize = 50'000);

}  // namespace leitstand::test
