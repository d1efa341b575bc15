#include <algorithm>

#include <gtest/gtest.h>

#include "core/mapping/live/scan_doubts.h"
#include "tests/simulation/mapping/mapped_drive.h"

namespace leitstand::simulation::test {
namespace {

std::size_t slicesIn(const RecordedDrive& drive) {
    return static_cast<std::size_t>(std::count_if(
        drive.received.begin(), drive.received.end(),
        [](const RecordedDrive::Received& received) { return received.sample.sample.is<CloudSample>(); }));
}

std::size_t slicesIn(const std::vector<LiveScan>& scans) {
    std::size_t count = 0;
    for (const LiveScan& scan : scans) count += static_cast<std::size_t>(scan.slices);
    return count;
}

TEST(LiveTrouble, ARobotThatStopsScansAndGoesIsMapped) {
    const RecordedDrive drive = stopScanGo(2, 5);
    const MappedDrive result = mapped(drive, cutScans(drive));
    ASSERT_GE(result.scans.size(), 5U);
    for (const LiveScan& scan : result.scans) EXPECT_EQ(scan.end, TurnEnd::Sweep);
    for (const Localisation& one : result.localisations) EXPECT_EQ(one.doubts, 0) << inWords(one.doubts);
    EXPECT_GT(drive.way, 1.0);
    const Pose mapInArena = result.live.truth.front() * result.live.found.front().inverse();
    for (std::size_t i = 0; i < result.scans.size(); ++i) {
        const Pose inArena = mapInArena * result.live.found[i];
        EXPECT_LE(distanceBetween(inArena, result.live.truth[i]), 0.08) << i;
        EXPECT_LE(inDegrees(angleBetween(inArena, result.live.truth[i])), 1.5) << i;
    }
}

TEST(LiveTrouble, ARadioGapCostsNoSliceAndTheMapGoesOn) {
    const RecordedDrive whole = exploredYellow(4, 45.0);
    const RecordedDrive drive = withRadioGap(whole, 15.0, 22.0);
    EXPECT_LT(drive.received.size(), whole.received.size());
    const auto scans = cutScans(drive);
    EXPECT_EQ(slicesIn(scans), slicesIn(whole)) << "one scan each, although some came twice";
    const MappedDrive result = mapped(drive, scans);
    int bridged = 0, uncertain = 0;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        bridged += scans[i].bridged ? 1 : 0;
        uncertain += result.localisations[i].doubts != 0 ? 1 : 0;
    }
    EXPECT_GE(bridged, 3);
    EXPECT_LE(uncertain, 5);
    EXPECT_EQ(result.localisations.back().doubts & ~static_cast<int>(ScanDoubt::Points), 0);
    const std::size_t last = scans.size() - 2;
    const Pose mapInArena = result.live.truth.front() * result.live.found.front().inverse();
    EXPECT_LE(distanceBetween(mapInArena * result.live.found[last], result.live.truth[last]), 0.1);
}

}  // namespace
}  // namespace leitstand::simulation::test
