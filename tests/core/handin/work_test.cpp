#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/handin/report_work.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using FindKind = FindSample::Kind;
using FindStatus = FindSample::Status;

/// A mission of which the test says what was done.
struct Worked {
    MissionState state;

    void find(FindKind kind, std::uint32_t number, FindStatus status) {
        FindSample one;
        one.kind = kind;
        one.number = number;
        one.status = status;
        state.finds.edit()[{kind, number}].victim = one;
    }
    void candidate(std::uint32_t id, double confidence, std::uint32_t filedAs,
                   std::vector<const char*> cues) {
        CandidateSample one;
        one.id = id;
        one.confidence = confidence;
        one.victim = filedAs;
        for (const char* kind : cues) one.cues.push_back({.kind = kind});
        state.candidates.edit()[id].candidate = one;
    }
    void decide(ScanPosesSample::Cause cause, bool undone = false) {
        ScanPosesSample poses;
        poses.cause = cause;
        Decision decision;
        decision.sequence = ++m_sequence;
        decision.undone = undone;
        decision.content = poses;
        state.decisions.edit().push_back(decision);
    }

private:
    std::uint64_t m_sequence = 0;
};

TEST(ReportWork, TellsWhoDidWhat) {
    Worked mission;
    mission.find(FindKind::Victim, 1, FindStatus::Confirmed);
    mission.find(FindKind::Victim, 2, FindStatus::Hypothesis);
    mission.find(FindKind::Victim, 3, FindStatus::Discarded);
    mission.find(FindKind::Code, 1, FindStatus::Confirmed);
    mission.candidate(1, 0.9, 1, {"heat", "sighting"});
    mission.candidate(2, 0.8, 0, {"co2"});
    mission.candidate(3, 0.1, 0, {"motion"});  // nobody was shown that
    mission.candidate(4, 0.9, 3, {"heat"});
    using Cause = ScanPosesSample::Cause;
    mission.decide(Cause::Registration);
    mission.decide(Cause::Operator);
    mission.decide(Cause::Operator, /*undone=*/true);
    mission.state.keyScans.edit()[1];
    const ReportWork work = workOf(mission.state);
    EXPECT_TRUE(work.mappedLive);
    EXPECT_EQ(work.filed, 3U);
    EXPECT_EQ(work.fromCandidates, 1U) << "the other one was discarded";
    EXPECT_EQ(work.confirmed, 2U);
    EXPECT_EQ(work.believed, 3U);
    EXPECT_EQ(work.sighted, 1U);
    EXPECT_THAT(work.cues, ElementsAre("co2", "heat"));
    EXPECT_EQ(work.scanDecisions, 1U);
}

TEST(ReportWork, OfAnEmptyMissionThereIsNone) {
    const ReportWork work = workOf(MissionState());
    EXPECT_FALSE(work.mappedLive);
    EXPECT_EQ(work.filed + work.believed + work.scanDecisions, 0U);
}

}  // namespace
}  // namespace leitstand::test
