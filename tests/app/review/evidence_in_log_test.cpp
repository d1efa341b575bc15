#include "app/services/finds/evidence_in_log.h"

#include <utility>

#include <gtest/gtest.h>

#include "app/services/handin/report_source.h"
#include "app/services/log/event_decoder.h"
#include "core/event/find_sample.h"
#include "core/event/status_samples.h"
#include "core/io/bag/bag_reader.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

constexpr const char* Gas = "/kurt3d/co2";
constexpr const char* Left = "/kurt3d/left/image/compressed";
constexpr const char* Right = "/kurt3d/right/image/compressed";

/// A mission whose finds other stations filed.
class ToldEvidenceTest : public testing::Test {
protected:
    static Time at(double seconds) { return WrittenMission::at(seconds); }
    /// A reading received at @p seconds, stamped @p stamp by the robot; its sequence.
    std::uint64_t smell(double seconds, double stamp, double ppm = 420.0) {
        m_mission.publish(seconds, Gas, GasSample{{at(stamp), ""}, "co2", ppm});
        return m_mission.sequence();
    }
    /// Sequence in this log of what another station told: stamped @p stamp, of a find at @p found.
    std::uint64_t reported(const char* topic, double stamp, double found, std::uint64_t own = 0) {
        m_mission.close();
        auto bag = std::move(BagReader::open(m_mission.folder())).value();
        EventDecoder decoder({WrittenMission::robot()});
        FindSample find;
        find.found = at(found);
        return sequenceInLog(*bag, decoder, {"", topic, own, at(stamp)}, find);
    }

    const TemporaryFolder m_folder;
    WrittenMission m_mission{m_folder / "ours", 0.0};
};

TEST_F(ToldEvidenceTest, IsTheEventOfTheSameTopicAndStamp) {
    smell(9.9, 9.8);
    const std::uint64_t meant = smell(10.0, 9.9);
    smell(10.1, 10.0);
    EXPECT_EQ(reported(Gas, 9.9, 10.5), meant);
    EXPECT_EQ(reported(Gas, 9.9, 3000.0), meant) << "the other station's clock is off, the robot's is not";
}

TEST_F(ToldEvidenceTest, IsFoundWhereTheRobotsClockOrTheOtherStationsIsOff) {
    const std::uint64_t meant = smell(10.0, 5000.0);
    EXPECT_EQ(reported(Gas, 5000.0, 10.5), meant);
    EXPECT_EQ(reported(Gas, 5000.0, 55.0), meant);
}

TEST_F(ToldEvidenceTest, IsNothingElseThatCameThen) {
    m_mission.sayPicture(10.0, 50);
    smell(10.05, 10.05);
    smell(10.15, 10.15);
    EXPECT_EQ(reported(Right, 10.0, 10.5), 0U) << "the left camera's picture has that stamp";
    EXPECT_EQ(reported(Gas, 10.0, 10.5), 0U) << "so has no reading";
    EXPECT_EQ(reported(Left, 10.05, 10.5), 0U) << "nor has the picture that of a reading";
    EXPECT_EQ(reported("/crawler/left", 10.0, 10.5), 0U) << "nobody knows that robot";
}

TEST_F(ToldEvidenceTest, IsNotLookedForBeyondAMinute) {
    smell(10.0, 5000.0);
    EXPECT_EQ(reported(Gas, 5000.0, 75.0), 0U);
}

TEST_F(ToldEvidenceTest, OfTheStationItselfGoesByItsNumber) {
    const std::uint64_t first = smell(10.0, 10.0);
    smell(11.0, 11.0);
    EXPECT_EQ(reported(Gas, 11.0, 11.5, first), first);
    EXPECT_EQ(reported(Gas, 11.0, 11.5, 4711), 4711U) << "also where that is lost";
}

TEST_F(ToldEvidenceTest, IsWhatTheReportShows) {
    m_mission.sayKeyScan(0.0, 1, 0.0);
    smell(9.0, 9.0);
    smell(10.0, 10.0, 900.0);
    m_mission.close();
    auto opened = ReportSource::open(m_mission.folder());
    ASSERT_TRUE(opened) << opened.error().text;
    ReportSource source = std::move(opened).value();
    FindSample find;
    find.found = at(10.5);
    const auto shown = source.event({"gas", Gas, 0, at(10.0)}, find);
    ASSERT_TRUE(shown) << shown.error().text;
    EXPECT_EQ(shown->sample.get<GasSample>().ppm, 900.0);
    EXPECT_FALSE(source.event({"picture", Left, 0, at(10.0)}, find)) << "only the other log has it";
}

}  // namespace
}  // namespace leitstand::test
