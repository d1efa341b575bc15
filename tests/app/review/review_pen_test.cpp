#include "app/services/review/review_pen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/recorded/review_index.h"
#include "app/services/recorded/review_log.h"
#include "app/services/review/playing/until_written.h"
#include "app/services/review/review_evidence.h"
#include "core/event/candidate_sample.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/session_state.h"
#include "tests/app/review/written_mission.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class ReviewPenTest : public testing::Test {
protected:
    void SetUp() override {
        WrittenMission mission(m_mission);
        writeMinute(mission);
    }
    [[nodiscard]] std::unique_ptr<ReviewPen> pen() const {
        return std::make_unique<ReviewPen>(m_mission, std::vector{Mission::robot()}, "reviewer", "test");
    }
    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
};

TEST_F(ReviewPenTest, WhatWasRecordedStaysAsItIs) {
    const auto before = opened(m_mission);
    const std::string file = before->sessions().front().file.string();
    const auto size = std::filesystem::file_size(file);
    const auto written = std::filesystem::last_write_time(file);
    {
        const auto writes = pen();
        EXPECT_EQ(writes->state(), nullptr) << "no session before there is something to write";
        EXPECT_THAT(opened(m_mission)->sessions(), SizeIs(1));
        ASSERT_TRUE(writes->note(Mission::at(33.0), "kurt3d", "the door was open").ok());
    }
    EXPECT_EQ(std::filesystem::file_size(file), size);
    EXPECT_EQ(std::filesystem::last_write_time(file), written);
    EXPECT_THAT(opened(m_mission)->sessions(), SizeIs(2));
}

TEST_F(ReviewPenTest, ANoteStandsAtTheMomentThatItIsAbout) {
    {
        const auto writes = pen();
        ASSERT_TRUE(writes->note(Mission::at(33.0), "kurt3d", "the door was open").ok());
        ASSERT_THAT(writes->marks(), SizeIs(1));
        EXPECT_EQ(writes->marks().front().at, Mission::at(33.0));
        EXPECT_FALSE(writes->note(Mission::at(33.0), "", "").ok());
    }
    const auto log = ReviewLog::open(m_mission).value();
    const ReviewIndexPtr index = indexOf(*log);
    EXPECT_THAT(index->stretches, SizeIs(2)) << "the review is a session of its own, later";
    const TimelineMark* const mark = markAfter(index->marks, Mission::at(32.9));
    ASSERT_NE(mark, nullptr);
    EXPECT_EQ(mark->text, "the door was open");
    EXPECT_EQ(mark->at, Mission::at(33.0));
}

TEST_F(ReviewPenTest, AVictimIsCorrectedAndTheCorrectionTakenBack) {
    const auto writes = pen();
    FindSample victim =
        ReviewLog::open(m_mission).value()->stateAt(Mission::at(60.0)).finds->begin()->second.victim;
    ASSERT_EQ(victim.status, FindSample::Status::Confirmed);
    victim.status = FindSample::Status::Discarded;
    victim.text = "a heap of rags";
    ASSERT_TRUE(writes->correct(victim).ok());
    const auto now = [&] { return writes->state()->finds->begin()->second.victim; };
    EXPECT_EQ(now().status, FindSample::Status::Discarded);
    EXPECT_EQ(now().station, "reviewer");
    EXPECT_TRUE(writes->canUndo());
    ASSERT_TRUE(writes->undo().ok());
    EXPECT_EQ(now().status, FindSample::Status::Confirmed);
    EXPECT_FALSE(writes->canUndo()) << "the mission's own decisions are not this pen's";
    EXPECT_FALSE(writes->undo().ok());
    victim.number = 77;
    const auto unknown = writes->correct(victim);
    ASSERT_FALSE(unknown.ok());
    EXPECT_THAT(unknown.error().text, HasSubstr("V77"));
}

TEST_F(ReviewPenTest, FindsAreMergedAndMoved) {
    const auto folder = m_folder / "two";
    {
        WrittenMission mission(folder);
        writeMinute(mission);
        mission.sayVictim(61.0, 2, FindSample::Status::Hypothesis);
        mission.close();
    }
    ReviewPen writes(folder, {Mission::robot()}, "reviewer", "test");
    const FindKey first{FindSample::Kind::Victim, 1}, second{FindSample::Kind::Victim, 2};
    const auto now = [&](const FindKey& find) { return writes.state()->finds->at(find).victim; };
    ASSERT_TRUE(writes.merge(second, 1).ok());
    EXPECT_EQ(now(second).mergedInto, 1U);
    EXPECT_EQ(now(second).station, "reviewer");
    const Eigen::Vector3d before = now(first).positionInMap, there(2.0, -0.4, 0.0);
    ASSERT_TRUE(writes.move(first, there).ok());
    EXPECT_TRUE(now(first).positionInMap.isApprox(Eigen::Vector3d(2.0, -0.4, before.z())))
        << now(first).positionInMap.transpose() << ": as high as it was";
    EXPECT_EQ(now(first).status, FindSample::Status::Confirmed) << "it is the same find";
    ASSERT_TRUE(writes.undo().ok());
    EXPECT_TRUE(now(first).positionInMap.isApprox(before));
    EXPECT_EQ(now(second).mergedInto, 1U) << "one at a time";
    ASSERT_TRUE(writes.undo().ok());
    EXPECT_EQ(now(second).mergedInto, 0U);
    EXPECT_FALSE(writes.merge(first, 9).ok());
    EXPECT_FALSE(writes.move({FindSample::Kind::Hazard, 1}, there).ok());
}

TEST_F(ReviewPenTest, WhatNobodyFiledIsFiledWithThePicturesOfItsMoment) {
    const auto log = ReviewLog::open(m_mission).value();
    const auto index = indexOf(*log);
    ReviewScene scene(*log, *index);
    const ReviewMomentPtr moment = scene.at(Mission::at(12.04));
    const Eigen::Vector3d there(3.0, 1.5, 0.2);
    const FrozenEvidence seen = evidenceAt(*moment, "kurt3d", *moment->mission, there);
    EXPECT_EQ(seen.scan, 3U) << "the newest by then";
    ASSERT_THAT(seen.evidence, SizeIs(1));
    EXPECT_EQ(seen.evidence.front().kind, "picture");
    EXPECT_EQ(seen.evidence.front().sequence, moment->pictures.front().sequence);
    EXPECT_THAT(evidenceAt(*moment, "crawler", *moment->mission, there).evidence, SizeIs(0))
        << "another robot";
    const auto writes = pen();
    using Kind = FindSample::Kind;
    ASSERT_TRUE(writes->file(Kind::Hazard, seen).ok());
    const FindKey hazard{Kind::Hazard, 1}, second{Kind::Victim, 2};
    ASSERT_TRUE(writes->state()->finds->contains(hazard));
    const FindSample filed = writes->state()->finds->at(hazard).victim;
    EXPECT_EQ(filed.found, Mission::at(12.04));
    EXPECT_EQ(filed.robot, "kurt3d");
    EXPECT_EQ(filed.status, FindSample::Status::Hypothesis);
    EXPECT_TRUE(filed.positionInMap.isApprox(there + Eigen::Vector3d(0.5, 0, 0)))
        << "it hangs on the third scan, which was moved later";
    ASSERT_TRUE(writes->file(Kind::Victim, seen).ok());
    EXPECT_TRUE(writes->state()->finds->contains(second)) << "V1 lies elsewhere";
    const std::size_t finds = writes->state()->finds->size();
    ASSERT_TRUE(writes->file(Kind::Victim, seen).ok());
    EXPECT_EQ(writes->state()->finds->size(), finds) << "the same one again";
    ASSERT_TRUE(writes->undo().ok());
    ASSERT_TRUE(writes->undo().ok());
    EXPECT_FALSE(writes->state()->finds->contains(second));
    EXPECT_TRUE(writes->state()->finds->contains(hazard));
}

TEST_F(ReviewPenTest, WhatAnEarlierReviewWroteIsTakenBack) {
    const auto read = [this] { return indexOf(*ReviewLog::open(m_mission).value()); };
    const auto notes = [](const std::vector<TimelineMark>& marks) {
        std::vector<std::string> texts;
        for (const TimelineMark& mark : marks) {
            if (mark.kind == TimelineMark::Kind::Note) texts.push_back(mark.text);
        }
        return texts;
    };
    const ReviewIndexPtr recorded = read();
    {
        const auto writes = pen();
        writes->know(recorded->finished);
        EXPECT_FALSE(writes->canUndo()) << "no review wrote anything";
        ASSERT_TRUE(writes->note(Mission::at(33.0), "kurt3d", "a lamp").ok());
        FindSample victim = recorded->finished->finds->begin()->second.victim;
        victim.status = FindSample::Status::Discarded;
        ASSERT_TRUE(writes->correct(victim).ok());
    }
    const ReviewIndexPtr reviewed = read();
    EXPECT_NE(reviewed->finished->sessions->back().ended, 0U) << "the review says when it was over";
    EXPECT_THAT(notes(reviewed->marks), ElementsAre("a lamp", "door on the left"));
    {
        const auto writes = pen();
        EXPECT_FALSE(writes->canUndo()) << "the mission is still read";
        writes->know(reviewed->finished);
        ASSERT_TRUE(writes->canUndo());
        EXPECT_EQ(writes->state(), nullptr) << "nothing is written by that";
        ASSERT_TRUE(writes->undo().ok());
        const auto now = [&] { return writes->state()->finds->begin()->second.victim.status; };
        EXPECT_EQ(now(), FindSample::Status::Confirmed);
        EXPECT_THAT(*writes->state()->notes, SizeIs(2)) << "one at a time";
        ASSERT_TRUE(writes->undo().ok());
        auto marks = reviewed->marks;
        dropUndone(marks, *writes->state());
        EXPECT_THAT(notes(marks), ElementsAre("door on the left"));
        EXPECT_FALSE(writes->canUndo()) << "the rest was recorded";
        EXPECT_FALSE(writes->undo().ok());
        EXPECT_EQ(now(), FindSample::Status::Confirmed);
    }
    const ReviewIndexPtr after = read();
    EXPECT_THAT(notes(after->marks), ElementsAre("door on the left"));
    EXPECT_EQ(after->finished->notes->size(), recorded->finished->notes->size());
    const auto again = pen();
    again->know(after->finished);
    EXPECT_FALSE(again->canUndo());
    EXPECT_FALSE(again->undo().ok());
    EXPECT_EQ(again->state(), nullptr) << "no session for nothing";
}

TEST_F(ReviewPenTest, AMissionThatWentOnAfterAReviewIsNoPartOfIt) {
    const auto folder = m_folder / "resumed";
    WrittenMission mission(folder);
    writeMinute(mission);
    mission.close();
    const auto session = [&](double seconds, const std::string& station) {
        SessionSample start;
        start.stamp = Mission::at(seconds);
        start.station = station;
        start.title = "Review";
        mission.publish(seconds, std::string(station_topic::Sessions), start);
    };
    const auto note = [&](double seconds, const std::string& text) {
        mission.publish(seconds, std::string(station_topic::Notes),
                        NoteSample{.stamp = Mission::at(seconds), .station = "x", .robot = {}, .text = text});
    };
    session(100.0, "review-elsewhere");
    note(101.0, "of the review");
    mission.close();  // cut off: no end is said
    session(200.0, "test");
    note(201.0, "of a station that is called like one");
    mission.close();
    ReviewPen writes(folder, {Mission::robot()}, "reviewer", "test");
    writes.know(indexOf(*ReviewLog::open(folder).value())->finished);
    ASSERT_TRUE(writes.undo().ok());
    std::vector<std::string> texts;
    const MissionStatePtr now = writes.state();
    for (const auto& one : *now->notes) texts.push_back(one.sample.text);
    EXPECT_THAT(texts, ElementsAre("door on the left", "of a station that is called like one"));
    EXPECT_FALSE(writes.canUndo());
}

/// A minute in which the station believed in somebody whom nobody filed.
class ReviewPenAndCandidateTest : public ReviewPenTest {
protected:
    void SetUp() override {
        m_candidate.stamp = Mission::at(31.0);
        m_candidate.station = "test";
        m_candidate.id = 7;
        m_candidate.positionInMap = {4.0, 1.0, 0.3};
        m_candidate.confidence = 0.8;
        m_candidate.cues.push_back({.kind = "heat", .robot = "kurt3d", .value = 33.5});
        WrittenMission mission(m_mission);
        writeMinute(mission);
        mission.publish(61.0, std::string(station_topic::Candidates), m_candidate);
        m_candidate.stamp = Mission::at(64.0);  // told anew, while somebody drives it by hand
        m_candidate.confidence = 0.9;
        ModeSample byHand;
        byHand.mode = "manual";
        mission.publish(63.0, Mission::robot().stream(StreamRole::Mode)->topic, byHand);
        mission.publish(64.0, std::string(station_topic::Candidates), m_candidate);
        mission.close();
    }
    CandidateSample m_candidate;
};

TEST_F(ReviewPenAndCandidateTest, ItIsFiled) {
    const auto pen = this->pen();
    ReviewPen& writes = *pen;
    ASSERT_TRUE(writes.fileCandidate(7).ok());
    const FindKey second{FindSample::Kind::Victim, 2};
    ASSERT_TRUE(writes.state()->finds->contains(second));
    const FindSample filed = writes.state()->finds->at(second).victim;
    EXPECT_EQ(filed.heat.value, 33.5);
    EXPECT_EQ(filed.found, Mission::at(31.0)) << "when it was told first";
    EXPECT_TRUE(filed.autonomous) << "so it drove then";
    EXPECT_TRUE(filed.positionInMap.isApprox(m_candidate.positionInMap));
    EXPECT_TRUE(isFiled(*writes.state(), m_candidate)) << "it is not shown beside it";
    EXPECT_EQ(writes.state()->candidates->at(7).candidate.victim, 2U)
        << "a station had told, so says the report";
    ASSERT_TRUE(writes.undo().ok());
    EXPECT_FALSE(isFiled(*writes.state(), m_candidate));
    EXPECT_FALSE(writes.fileCandidate(8).ok());
}

TEST(UntilWritten, WhatNobodyConfirmsIsAnErrorAndSoIsWhatTheLogComplainsOf) {
    using std::chrono::milliseconds;
    const auto well = [] { return std::string(); };
    int asked = 0;
    EXPECT_TRUE(untilWritten([&] { return ++asked == 3; }, well).ok());
    const auto silent = untilWritten([] { return false; }, well, milliseconds(5));
    ASSERT_FALSE(silent.ok());
    EXPECT_THAT(silent.error().text, HasSubstr("not known whether"));
    const auto full = untilWritten([] { return true; }, [] { return std::string("the disk is full"); });
    ASSERT_FALSE(full.ok());
    EXPECT_EQ(full.error().text, "the disk is full");
}

TEST_F(ReviewPenAndCandidateTest, ItIsDismissedAndThatIsTakenBack) {
    const auto dismissed = [this](const MissionStatePtr& state) {
        return state->candidates->at(m_candidate.id).candidate.dismissed;
    };
    {
        const auto writes = pen();
        EXPECT_FALSE(writes->dismiss(8).ok());
        EXPECT_FALSE(writes->canUndo());
        ASSERT_TRUE(writes->note(Mission::at(31.0), "kurt3d", "a lamp").ok());
        ASSERT_TRUE(writes->dismiss(7).ok());
        EXPECT_TRUE(dismissed(writes->state()));
        ASSERT_TRUE(writes->undo().ok());
        EXPECT_FALSE(dismissed(writes->state()));
        EXPECT_THAT(writes->marks(), SizeIs(1)) << "the note was written before it";
        ASSERT_TRUE(writes->undo().ok());
        EXPECT_THAT(writes->marks(), SizeIs(0));
        EXPECT_FALSE(writes->canUndo());
        ASSERT_TRUE(writes->dismiss(7).ok());
    }
    const auto log = ReviewLog::open(m_mission).value();
    const MissionStatePtr finished = indexOf(*log)->finished;
    EXPECT_TRUE(dismissed(finished)) << "as whoever opens the mission next has it";
    const auto writes = pen();
    writes->know(finished);
    ASSERT_TRUE(writes->undo().ok());
    EXPECT_FALSE(dismissed(writes->state())) << "also by whoever opens it next";
    EXPECT_FALSE(writes->canUndo());
}

TEST_F(ReviewPenAndCandidateTest, WhatWasDismissedWhileItWasRecordedStaysSo) {
    {
        WrittenMission mission(m_folder / "dismissed");
        writeMinute(mission);
        m_candidate.dismissed = true;
        mission.publish(61.0, std::string(station_topic::Candidates), m_candidate);
        m_candidate.stamp = Mission::at(64.0);  // told anew, while somebody drives it by hand
        m_candidate.confidence = 0.9;
        ModeSample byHand;
        byHand.mode = "manual";
        mission.publish(63.0, Mission::robot().stream(StreamRole::Mode)->topic, byHand);
        mission.publish(64.0, std::string(station_topic::Candidates), m_candidate);
        mission.close();
    }
    ReviewPen writes(m_folder / "dismissed", {Mission::robot()}, "reviewer", "test");
    ASSERT_TRUE(writes.dismiss(m_candidate.id).ok());
    EXPECT_FALSE(writes.canUndo());
    EXPECT_FALSE(writes.undo().ok());
    const auto dismissed = [&] { return writes.state()->candidates->at(m_candidate.id).candidate.dismissed; };
    EXPECT_TRUE(dismissed());

    // As it was before that it can be filed.
    ASSERT_TRUE(writes.fileCandidate(m_candidate.id).ok());
    const FindKey second{FindSample::Kind::Victim, 2};
    ASSERT_TRUE(writes.state()->finds->contains(second));
    ASSERT_TRUE(writes.undo().ok());
    EXPECT_FALSE(writes.state()->finds->contains(second)) << "at once";
    EXPECT_TRUE(dismissed());
    EXPECT_FALSE(writes.canUndo());
}

TEST_F(ReviewPenTest, SaysWhenSomebodyElseWritesTheMission) {
    const auto one = pen(), other = pen();
    ASSERT_TRUE(one->note(Mission::at(1.0), "", "first").ok());
    const auto second = other->note(Mission::at(2.0), "", "second");
    ASSERT_FALSE(second.ok());
    EXPECT_THAT(second.error().text, HasSubstr("mission"));
}

}  // namespace
}  // namespace leitstand::test
