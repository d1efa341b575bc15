#include "app/services/finds/evidence_reader.h"

#include <future>

#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/event/stream_role.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;

class EvidenceReaderTest : public testing::Test {
protected:
    EvidenceReaderTest() {
        Mission mission(m_mission);
        mission.sayOdometry(0.5, 0.0);
        mission.sayPicture(1.0, 90);
        find.number = 1;
        find.evidence = {{"picture", Mission::robot().stream(StreamRole::Picture, "left")->topic,
                          mission.sequence(), Mission::at(1.0)}};
        mission.sayPicture(2.0, 200);
    }
    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    FindSample find;
};

TEST_F(EvidenceReaderTest, APictureIsTheOneThatTheFindNames) {
    const ReadEvidence read = readEvidence(m_mission, find);
    ASSERT_EQ(read.pictures.size(), 1U);
    EXPECT_TRUE(read.written);
    EXPECT_EQ(read.pictures.front().robot, "kurt3d");
    EXPECT_EQ(read.pictures.front().sensor, "left");
    EXPECT_EQ(read.pictures.front().picture.width, 32);
    EXPECT_NEAR(std::to_integer<int>(read.pictures.front().picture.bytes.front()), 90, 3);
}

TEST_F(EvidenceReaderTest, WhatTheLogDoesNotHaveYetIsToldSo) {
    find.evidence.front().sequence += 1'000;
    const ReadEvidence read = readEvidence(m_mission, find);
    EXPECT_TRUE(read.pictures.empty());
    EXPECT_FALSE(read.written);
}

TEST_F(EvidenceReaderTest, WhatIsNoPictureIsLeftOutAndNoMissionIsNoPicture) {
    find.evidence.front().kind = "gas";
    EXPECT_TRUE(readEvidence(m_mission, find).pictures.empty());
    EXPECT_TRUE(readEvidence(m_folder / "nowhere", find).pictures.empty());
}

TEST_F(EvidenceReaderTest, AnswersOnItsOwnThread) {
    std::promise<std::size_t> answer;
    EvidenceReader reader(m_mission, [&](const FindSample&, const ReadEvidence& read) {
        answer.set_value(read.pictures.size());
    });
    reader.want(find);
    EXPECT_EQ(answer.get_future().get(), 1U);
}

}  // namespace
}  // namespace leitstand::test
