#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/base/result.h"
#include "core/cloud/scan.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {

/// Whether two points have the same bits' worth: equal, or both no echo.
inline bool samePoint(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return a == b || (!a.allFinite() && !b.allFinite());
}

/// The points, grid, intensities and labels of two scans are the very same.
inline void expectSameScan(const Scan& actual, const Scan& expected) {
    EXPECT_EQ(actual.rows, expected.rows);
    EXPECT_EQ(actual.columns, expected.columns);
    if (expected.organised()) {
        EXPECT_EQ(actual.sweep, expected.sweep);
    }
    EXPECT_EQ(actual.intensities, expected.intensities);
    EXPECT_EQ(actual.labels, expected.labels);
    ASSERT_EQ(actual.points.size(), expected.points.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < expected.points.size(); ++i) {
        if (!samePoint(actual.points[i], expected.points[i])) ++different;
    }
    EXPECT_EQ(different, 0U);
}

/// Writes @p text to @p file and tells where that is.
inline std::filesystem::path written(const std::filesystem::path& file, const std::string& text) {
    writeText(file, text);
    return file;
}

/// Text of the error, or a remark that there was none.
template <class T>
std::string errorOf(const Result<T>& result) {
    return result.ok() ? "no error" : result.error().text;
}

}  // namespace leitstand::test
