// Videos in a mission's log: recorded as they came, seen at any moment, forwards and backwards, kept as
// evidence.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "app/services/finds/evidence_reader.h"
#include "app/services/log/event_decoder.h"
#include "app/services/log/log_entry.h"
#include "app/services/recorded/review_log.h"
#include "app/services/thinning/mission_thinning.h"
#include "core/event/find_sample.h"
#include "core/event/raw_event.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/video/video_packet.h"
#include "tests/app/review/written_mission.h"
#include "tests/core/perception/video/filmed.h"
#include "tests/support/temporary_folder.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;

/// Forty seconds of a robot with a camera of 10 Hz, a key picture every 4 s.
class VideoReview : public testing::Test {
protected:
    static constexpr int Pictures = 400, KeyEvery = 40;
    VideoReview() {
        Mission mission(m_mission);
        for (int i = 0; i < Pictures; ++i) {
            mission.publish(timeOf(i), topic(), m_film[static_cast<std::size_t>(i)]);
            m_sequences[i] = mission.sequence();
            if (i % 5 == 0) mission.sayOdometry(timeOf(i) + 0.01, 0.01 * i);
        }
        mission.publish(50.0, "/leitstand/victims", findWith(57));
    }
    static double timeOf(int picture) { return 0.1 * (picture + 1); }
    static std::string topic() { return Mission::robot().stream(StreamRole::Picture, "left")->topic; }
    static void expectPicture(const std::optional<Event>& event, int number) {
        ASSERT_TRUE(event) << number;
        const auto picture = decodePicture(event->sample.get<PictureSample>());
        ASSERT_TRUE(picture) << number << ": " << picture.error().text;
        EXPECT_LT(difference(*picture, movingScene(number, 64, 48)), 8.0) << number;
    }
    [[nodiscard]] FindSample findWith(int picture) const {
        FindSample find;
        find.number = 1;
        find.stamp = find.found = Mission::at(timeOf(picture));
        find.evidence = {{"picture", topic(), m_sequences.at(picture),
                          m_film[static_cast<std::size_t>(picture)].header.stamp}};
        return find;
    }

    const std::vector<PictureSample> m_film = filmed(Pictures, KeyEvery, VideoCodec::H264, 64, 48);
    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    std::map<int, std::uint64_t> m_sequences;
};

TEST_F(VideoReview, EveryMomentShowsItsPictureForwardsAndBackwards) {
    const auto log = ReviewLog::open(m_mission);
    ASSERT_TRUE(log) << log.error().text;
    for (const int number : {355, 354, 350, 120, 119, 399, 7, 201, 200, 199, 0})
        expectPicture((*log)->newest(topic(), Mission::at(timeOf(number) + 0.02)), number);
}

TEST_F(VideoReview, PlayingFromAMomentShowsEachPicture) {
    const auto log = ReviewLog::open(m_mission);
    ASSERT_TRUE(log) << log.error().text;
    // Across the border of two segments of the log, which begin between key pictures.
    int number = 93;
    (*log)->events(Mission::at(timeOf(92) + 0.02), Mission::at(timeOf(112) + 0.02), [&](const Event& event) {
        if (event.topic == topic()) expectPicture(event, number++);
    });
    EXPECT_EQ(number, 113);
}

TEST_F(VideoReview, TheLogHasThePicturesAsTheyCame) {
    auto bag = BagReader::open(m_mission);
    ASSERT_TRUE(bag) << bag.error().text;
    EventDecoder decoder({Mission::robot()});
    const auto raw = (*bag)->event(m_sequences.at(57));
    ASSERT_TRUE(raw);
    EXPECT_EQ(raw->type, "ffmpeg_image_transport_msgs/msg/FFMPEGPacket");
    const auto event = decodedAlone(**bag, decoder, *raw);
    ASSERT_TRUE(event);
    const auto& picture = event->sample.get<PictureSample>();
    const auto& sent = m_film[57].content.bytes;
    EXPECT_TRUE(
        std::equal(sent.begin(), sent.end(), picture.content.bytes.begin(), picture.content.bytes.end()));
    EXPECT_EQ(picture.video->sinceKey, 57 - 40);
}

TEST_F(VideoReview, EvidenceOfAFindIsThePictureThatItNames) {
    const ReadEvidence read = readEvidence(m_mission, findWith(57));
    ASSERT_EQ(read.pictures.size(), 1U);
    EXPECT_LT(difference(read.pictures.front().picture, movingScene(57, 64, 48)), 8.0);
}

/// The same video as messages of CompressedImage, as some cameras send it.
class VideoInCompressedImages : public testing::Test {
protected:
    static constexpr int Pictures = 60;
    VideoInCompressedImages() {
        auto writer = BagWriter::open(m_mission);
        EXPECT_TRUE(writer) << writer.error().text;
        TopicInfo info;
        info.name = topic();
        info.type = "sensor_msgs/msg/CompressedImage";
        (*writer)->addTopic(info);
        for (int i = 0; i < Pictures; ++i) {
            RawEvent event;
            event.sequence = static_cast<std::uint64_t>(i) + 1;
            event.received = Mission::at(0.1 * (i + 1));
            event.topic = info.name;
            event.type = info.type;
            event.cdr = encode(m_film[static_cast<std::size_t>(i)], info.type).value();
            (*writer)->write(event);
        }
        EXPECT_TRUE((*writer)->close());
    }
    static std::string topic() { return Mission::robot().stream(StreamRole::Picture, "left")->topic; }

    const std::vector<PictureSample> m_film = filmed(Pictures, 20, VideoCodec::H264, 64, 48);
    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
};

TEST_F(VideoInCompressedImages, EachPictureIsFoundByWhoHasSeenNoneBefore) {
    for (const int number : {57, 20, 39, 3}) {
        auto bag = BagReader::open(m_mission);
        ASSERT_TRUE(bag) << bag.error().text;
        EventDecoder decoder({Mission::robot()});
        const auto raw = (*bag)->event(static_cast<std::uint64_t>(number) + 1);
        ASSERT_TRUE(raw);
        const auto event = decodedAlone(**bag, decoder, *raw);
        ASSERT_TRUE(event);
        const auto picture = decodePicture(event->sample.get<PictureSample>());
        ASSERT_TRUE(picture) << number << ": " << picture.error().text;
        EXPECT_LT(difference(*picture, movingScene(number, 64, 48)), 8.0) << number;
    }
}

TEST_F(VideoReview, AThinnedMissionKeepsKeyPicturesAndAllThatEvidenceNeeds) {
    const auto thin = m_folder / "thin";
    const auto done = thinMission(m_mission, thin, {});
    ASSERT_TRUE(done) << done.error().text;
    auto bag = BagReader::open(thin);
    ASSERT_TRUE(bag) << bag.error().text;
    std::vector<int> kept;
    for (const auto& [number, sequence] : m_sequences)
        if ((*bag)->event(sequence)) kept.push_back(number);
    std::vector<int> wanted;
    for (int i = 0; i < Pictures; ++i)
        if (i % KeyEvery == 0 || (i >= 40 && i <= 57)) wanted.push_back(i);
    EXPECT_EQ(kept, wanted);
    const auto log = ReviewLog::open(thin);
    ASSERT_TRUE(log) << log.error().text;
    expectPicture((*log)->newest(topic(), Mission::at(timeOf(57) + 0.02)), 57);
    expectPicture((*log)->newest(topic(), Mission::at(timeOf(85))), 80);
    ASSERT_EQ(readEvidence(thin, findWith(57)).pictures.size(), 1U);
}

}  // namespace
}  // namespace leitstand::test
