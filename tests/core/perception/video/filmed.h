#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/picture.h"
#include "core/perception/pictures/video/video_packet.h"

namespace leitstand::test {

/// Picture @p number of a scene that moves, in colour.
[[nodiscard]] Picture movingScene(int number, int width = 160, int height = 120);

/// The first @p count pictures of that scene as a video, a key picture every @p keyEvery, as messages bring
/// them: not linked.
[[nodiscard]] std::vector<PictureSample> filmed(int count, int keyEvery, VideoCodec codec = VideoCodec::H264,
                                                int width = 160, int height = 120);

/// Mean difference of the values of two pictures of one size, 0 to 255.
[[nodiscard]] double difference(const Picture& a, const Picture& b);

}  // namespace leitstand::test
