#include "app/services/offline/scan_session.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/services/scan_folder.h"
#include "tests/app/services/session_recorder.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

using test::SessionRecorder;
using test::writeDrive;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int Scans = 4;

class ScanSessionTest : public testing::Test {
protected:
    void SetUp() override { writeDrive(m_folder.path(), Scans); }

    [[nodiscard]] const Map& lastMap() {
        m_last = m_recorder.record().maps.back();
        return *m_last;
    }

    test::TemporaryFolder m_folder;
    SessionRecorder m_recorder;
    MapPtr m_last;
};

void expectTruePoses(const Map& map) {
    for (std::size_t i = 0; i < map.scans.size(); ++i) {
        const Pose truth = poseFrom({0.3 * static_cast<double>(i), 0, 0}, 0, 0, 0);
        EXPECT_LT(distanceBetween(map.scans[i].poseInMap, truth), 0.03) << "scan " << i;
    }
}

TEST_F(ScanSessionTest, TheMapGrowsScanByScanToTheTruePoses) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(1));
    const auto record = m_recorder.record();
    ASSERT_THAT(record.maps, SizeIs(Scans));
    for (std::size_t i = 0; i < Scans; ++i) EXPECT_THAT(record.maps[i]->scans, SizeIs(i + 1));
    expectTruePoses(lastMap());
    EXPECT_THAT(record.messages, IsEmpty());
    EXPECT_EQ(record.outcomes[0].added, Scans);
    EXPECT_FALSE(record.outcomes[0].cancelled);
    EXPECT_GT(record.outcomes[0].seconds, 0.0);
}

TEST_F(ScanSessionTest, ProgressNamesTheScanAndNeverRunsBackwards) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(1));
    const auto progress = m_recorder.record().progress;
    ASSERT_GE(progress.size(), 2u * Scans);
    double before = 0.0;
    for (const SessionProgress& step : progress) {
        EXPECT_GE(step.fraction, before - 1e-9);
        EXPECT_LE(step.fraction, 1.0);
        EXPECT_EQ(step.scans, Scans);
        EXPECT_THAT(step.name, HasSubstr("scan00" + std::to_string(step.scan - 1)));
        before = step.fraction;
    }
}

TEST_F(ScanSessionTest, ABrokenFileIsToldAndTheOthersAreRegistered) {
    test::writeText(m_folder / "scan001.3d", "1 2 3\n4 five 6\n");
    ScanSession session(m_recorder.listener());
    session.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(1));
    const auto messages = m_recorder.record().messages;
    ASSERT_THAT(messages, SizeIs(1));
    EXPECT_EQ(messages[0].severity, SessionMessage::Severity::Error);
    EXPECT_THAT(messages[0].text, HasSubstr("scan001.3d:2"));
    EXPECT_THAT(lastMap().scans, SizeIs(Scans - 1));
}

TEST_F(ScanSessionTest, ASourceThatIsNotThereIsToldAndTheOthersAreOpened) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder / "nowhere", m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(1));
    ASSERT_THAT(m_recorder.record().messages, SizeIs(1));
    EXPECT_THAT(m_recorder.record().messages[0].text, HasSubstr("nowhere"));
    EXPECT_THAT(lastMap().scans, SizeIs(Scans));
}

TEST_F(ScanSessionTest, AddedScansGoOnFromTheLast) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder / "scan000.3d", m_folder / "scan001.3d"}, {});
    session.open({m_folder / "scan002.3d", m_folder / "scan003.3d"}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(2));
    EXPECT_THAT(lastMap().scans, SizeIs(Scans));
    expectTruePoses(lastMap());
}

TEST_F(ScanSessionTest, AScanIsNotAddedTwice) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder.path()}, {});
    session.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(2));
    EXPECT_THAT(lastMap().scans, SizeIs(Scans));
    ASSERT_THAT(m_recorder.record().messages, SizeIs(1));
    EXPECT_EQ(m_recorder.record().messages[0].severity, SessionMessage::Severity::Warning);
    EXPECT_THAT(m_recorder.record().messages[0].text, HasSubstr("4 scans are in the map already"));
}

TEST_F(ScanSessionTest, RegisteringAgainKeepsAllScansInSightAndTakesTheNewSettings) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder.path()}, {});
    RegistrationSettings settings;
    settings.minimizer = Minimizer::Svd;
    settings.maxIterations = 3;
    session.registerAgain(settings);
    ASSERT_TRUE(m_recorder.waitForOutcomes(2));
    const auto maps = m_recorder.record().maps;
    ASSERT_THAT(maps, SizeIs(2 * Scans));
    for (std::size_t i = Scans; i < maps.size(); ++i) EXPECT_THAT(maps[i]->scans, SizeIs(Scans));
    for (std::size_t i = 1; i < Scans; ++i) EXPECT_LE(lastMap().scans[i].icp.iterations, 3);
    // The start poses stay those of the odometry, so that before and after can be compared.
    EXPECT_GT(distanceBetween(lastMap().scans[1].guessInMap, lastMap().scans[1].poseInMap), 0.005);
}

TEST_F(ScanSessionTest, ClearingEmptiesTheMapAndTheSameScansCanBeOpenedAnew) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(1));
    session.clear();
    ASSERT_TRUE(m_recorder.waitForOutcomes(2));
    EXPECT_THAT(lastMap().scans, IsEmpty());
    session.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(3));
    EXPECT_THAT(lastMap().scans, SizeIs(Scans));
    EXPECT_THAT(m_recorder.record().messages, IsEmpty());
}

TEST_F(ScanSessionTest, CancellingKeepsWhatWasRegistered) {
    std::atomic<ScanSession*> session = nullptr;
    m_recorder.onEvent = [&session](const SessionRecorder::Record& record) {
        if (record.maps.size() == 2) session.load()->cancel();
    };
    ScanSession own(m_recorder.listener());
    session = &own;
    own.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(1));
    EXPECT_TRUE(m_recorder.record().outcomes[0].cancelled);
    EXPECT_THAT(lastMap().scans, SizeIs(2));
}

TEST_F(ScanSessionTest, CancellingARegistrationBringsTheOldMapBack) {
    std::atomic<ScanSession*> session = nullptr;
    m_recorder.onEvent = [&session](const SessionRecorder::Record& record) {
        if (record.maps.size() == Scans + 2) session.load()->cancel();
    };
    ScanSession own(m_recorder.listener());
    session = &own;
    own.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(1));
    const MapPtr before = m_recorder.record().maps.back();
    RegistrationSettings settings;
    settings.maxIterations = 1;
    own.registerAgain(settings);
    ASSERT_TRUE(m_recorder.waitForOutcomes(2));
    EXPECT_TRUE(m_recorder.record().outcomes[1].cancelled);
    ASSERT_THAT(lastMap().scans, SizeIs(Scans));
    for (std::size_t i = 0; i < Scans; ++i) {
        EXPECT_TRUE(lastMap().scans[i].poseInMap.isApprox(before->scans[i].poseInMap));
        EXPECT_EQ(lastMap().scans[i].icp.iterations, before->scans[i].icp.iterations);
    }
}

TEST_F(ScanSessionTest, ACancelIsNeverLostWheneverItComes) {
    for (int round = 0; round < 20; ++round) {
        SessionRecorder recorder;
        ScanSession session(recorder.listener());
        session.open({m_folder.path()}, {});
        session.open({m_folder.path()}, {});
        session.cancel();
        ASSERT_TRUE(recorder.waitForOutcomes(2));
        EXPECT_TRUE(recorder.record().outcomes[0].cancelled) << "round " << round;
        EXPECT_TRUE(recorder.record().outcomes[1].cancelled) << "round " << round;
    }
}

TEST_F(ScanSessionTest, WorkGivenAfterACancelIsDone) {
    ScanSession session(m_recorder.listener());
    session.open({m_folder.path()}, {});
    session.cancel();
    session.open({m_folder.path()}, {});
    ASSERT_TRUE(m_recorder.waitForOutcomes(2));
    EXPECT_FALSE(m_recorder.record().outcomes[1].cancelled);
    EXPECT_THAT(lastMap().scans, SizeIs(Scans));
}

TEST_F(ScanSessionTest, ASessionCanEndAtAnyMomentOfItsWork) {
    for (std::size_t event = 1; event < 12; ++event) {
        SessionRecorder recorder;
        std::atomic<bool> reached = false;
        recorder.onEvent = [&](const SessionRecorder::Record& record) {
            if (record.maps.size() + record.progress.size() < event) return;
            reached = true;
            reached.notify_all();
        };
        {
            ScanSession session(recorder.listener());
            session.open({m_folder.path()}, {});
            session.registerAgain({});
            reached.wait(false);
        }
        const auto reported = recorder.record();
        EXPECT_LE(reported.maps.size(), 2u * Scans) << "event " << event;
    }
}

TEST(ScanSessionOnTheHall, ThreeScansAreRegisteredWithCertainty) {
    LEITSTAND_HALL_OR_SKIP(hall);
    SessionRecorder recorder;
    ScanSession session(recorder.listener());
    session.open({hall}, {});
    ASSERT_TRUE(recorder.waitForOutcomes(1));
    const MapPtr map = recorder.record().maps.back();
    ASSERT_THAT(map->scans, SizeIs(3));
    for (std::size_t i = 1; i < 3; ++i) {
        EXPECT_TRUE(map->scans[i].icp.converged);
        EXPECT_TRUE(map->scans[i].icp.certain());
    }
}

}  // namespace
}  // namespace leitstand
