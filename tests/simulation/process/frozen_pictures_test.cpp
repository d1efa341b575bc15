#include "robots/simulation/process/frozen_pictures.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/stream_role.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

HardwareSample pictureOf(const std::string& sensor, int content, StreamRole role = StreamRole::Picture) {
    const auto bytes = std::make_shared<std::vector<std::byte>>(8, static_cast<std::byte>(content));
    PictureSample picture;
    picture.header = {Time(content * 1s), sensor};
    picture.compressed = true;
    picture.content = {bytes, *bytes};
    return {role, sensor, picture};
}

/// What is said in place of @p sample: its content and its stamp in seconds.
std::pair<int, int> reported(FrozenPictures& cameras, HardwareSample sample, bool frozen) {
    cameras.pass(sample, frozen);
    const auto& picture = sample.sample.get<PictureSample>();
    return {static_cast<int>(picture.content.bytes.front()),
            static_cast<int>(picture.header.stamp.time_since_epoch() / 1s)};
}

TEST(FrozenPictures, AreTheLastOfEachCameraUnderNewStamps) {
    FrozenPictures cameras;
    EXPECT_EQ(reported(cameras, pictureOf("left", 1), false), std::pair(1, 1));
    EXPECT_EQ(reported(cameras, pictureOf("right", 2), false), std::pair(2, 2));
    EXPECT_EQ(reported(cameras, pictureOf("left", 3), false), std::pair(3, 3));
    EXPECT_EQ(reported(cameras, pictureOf("left", 4), true), std::pair(3, 4));
    EXPECT_EQ(reported(cameras, pictureOf("right", 5), true), std::pair(2, 5));
    EXPECT_EQ(reported(cameras, pictureOf("left", 6), true), std::pair(3, 6));
    EXPECT_EQ(reported(cameras, pictureOf("left", 7), false), std::pair(7, 7)) << "they go on";
}

TEST(FrozenPictures, ACameraThatSaidNothingYetSaysItsFirst) {
    FrozenPictures cameras;
    EXPECT_EQ(reported(cameras, pictureOf("left", 1), true), std::pair(1, 1));
    EXPECT_EQ(reported(cameras, pictureOf("left", 2), true), std::pair(1, 2));
}

TEST(FrozenPictures, InfraredGoesOn) {
    FrozenPictures cameras;
    EXPECT_EQ(reported(cameras, pictureOf("ir", 1, StreamRole::Thermal), true), std::pair(1, 1));
    EXPECT_EQ(reported(cameras, pictureOf("ir", 2, StreamRole::Thermal), true), std::pair(2, 2));
}

}  // namespace
}  // namespace leitstand::simulation::test
