#include "widgets/models/map/live_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
        liveSummaryOf(map, QStringLiteral("K"), Time(std::chrono::milliseconds(104'400)));
    EXPECT_THAT(summary.title.toStdString(), HasSubstr("2 key scans"));
    EXPECT_THAT(summary.title.toStdString(), HasSubstr("follows K"));
    EXPECT_THAT(summary.result.toStdString(), HasSubstr("last scan 1.4 s ago"));
    EXPECT_THAT(summary.result.toStdString(), testing::StartsWith("uncertain")) << "the age is what is cut";
    EXPECT_EQ(summary.tone, Tone::Attention);
}

TEST(LiveSummary, IsCalmBeforeTheFirstScan) {
    const MapSummary summary = liveSummaryOf({}, {}, Time{});
    EXPECT_EQ(summary.result, "");
    EXPECT_THAT(summary.title.toStdString(), Not(HasSubstr("follow")));
    EXPECT_EQ(summary.tone, Tone::Normal);
}

}  // namespace
}  // namespace leitstand::test
