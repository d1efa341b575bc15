#pragma once

#include <string>

#include <gtest/gtest.h>
#include <QImage>

namespace leitstand::test {

/// Whether @p picture looks like golden/@p name.png: at most 1 % of the pixels differ by more than 32 of 255
/// in a channel, since processors of other vector widths round differently at the edges of points. If not,
/// the picture and where it differs are saved in the working directory. With LEITSTAND_UPDATE_GOLDEN=1 the
/// picture becomes the golden one.
[[nodiscard]] testing::AssertionResult looksLikeGolden(const QImage& picture, const std::string& name);

}  // namespace leitstand::test
