#include "widgets/models/map/live_map_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/scan_pose.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::Not;

LiveKeyScan keyScan(std::uint64_t id, ScanTrust trust) {
    auto scan = std::make_shared<Scan>();
    scan->points.resize(1'000, Eigen::Vector3f::Zero());
    LiveKeyScan key;
    key.id = id;
    key.scan = std::move(scan);
    key.pose.trust = trust;
    key.pose.overlap = 0.83;
    key.matched = id - 1;
    key.entered = Time(std::chrono::seconds(100 + id));
    return key;
}

TEST(LiveSummary, CountsWhatIsShownAndTellsTheNewestScan) {
    LiveMap map;
    map.scans = {keyScan(1, ScanTrust::Certain), keyScan(2, ScanTrust::SetAside),
                 keyScan(3, ScanTrust::Uncertain)};
    const MapSummary summary =
        liveSummaryOf({map, {}, Time(std::chrono::milliseconds(104'400)), QStringLiteral("K")});
    EXPECT_THAT(summary.title.toStdString(), HasSubstr("2 key scans"));
    EXPECT_THAT(summary.title.toStdString(), HasSubstr("follows K"));
    EXPECT_THAT(summary.result.toStdString(), HasSubstr("last scan 1.4 s ago"));
    EXPECT_THAT(summary.result.toStdString(), testing::StartsWith("uncertain")) << "the age is what is cut";
    EXPECT_THAT(summary.result.toStdString(), HasSubstr("overlap 83"));
    EXPECT_EQ(summary.briefResult, "uncertain ? · last scan 1.4 s ago") << "beside a picture";
    EXPECT_THAT(summary.title.toStdString(), HasSubstr("points"));
    EXPECT_EQ(summary.briefTitle, "3D map · 2 key scans · follows K");
    EXPECT_EQ(summary.tone, Tone::Attention);
}

TEST(LiveSummary, TellsTheNewestScanThatWasLaidOntoTheMapAndWhenThatIsLongAgo) {
    LiveMap map;
    map.scans = {keyScan(1, ScanTrust::Certain), keyScan(2, ScanTrust::Certain)};
    RobotsInMap robots(2);
    robots[0].matched = Time(std::chrono::seconds(160));  // it stands, and goes on looking around
    const auto at = [&](int seconds) {
        return liveSummaryOf({map, robots, Time(std::chrono::seconds(seconds))});
    };
    EXPECT_THAT(at(162).result.toStdString(), HasSubstr("last scan 2.0 s ago"));
    EXPECT_FALSE(at(169).stale);
    EXPECT_EQ(at(169).tone, Tone::Normal);
    const MapSummary stale = at(172);
    EXPECT_TRUE(stale.stale);
    EXPECT_THAT(stale.result.toStdString(), testing::StartsWith("last scan 12 s ago"));
    EXPECT_EQ(stale.tone, Tone::Attention);
    robots[0].matched.reset();
    EXPECT_FALSE(at(172).stale) << "another station's, or of an earlier session: nobody knows here";
}

TEST(LiveSummary, NamesTheStationThatMakesIt) {
    const LiveMap map;
    const RobotsInMap robots;
    LiveMapFacts facts{map, robots};
    facts.maker = QStringLiteral("Desk 2");
    EXPECT_THAT(liveSummaryOf(facts).title.toStdString(), HasSubstr("made by Desk 2"));
}

TEST(LiveSummary, IsCalmBeforeTheFirstScan) {
    const MapSummary summary = liveSummaryOf({LiveMap(), {}, Time{}});
    EXPECT_EQ(summary.result, "");
    EXPECT_THAT(summary.title.toStdString(), Not(HasSubstr("follow")));
    EXPECT_EQ(summary.tone, Tone::Normal);
}

}  // namespace
}  // namespace leitstand::test
