#include "core/mission/loops/moved_finds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"
#include "tests/core/mission/event_stream.h"

namespace leitstand {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

TEST(MovedFinds, AreThoseOnScansThatMoveFarEnoughAndAreNotDiscarded) {
    Fold fold;
    std::uint64_t sequence = 0;
    const auto add = [&](Sample sample) { fold.add(test::event(++sequence, std::move(sample))); };
    add(test::keyScan(1, 0.0));
    add(test::keyScan(2, 1.0));
    for (std::uint32_t number = 1; number <= 4; ++number) {
        FindSample victim = test::victim(number, "");
        victim.scan = number == 1 ? 1 : number == 4 ? 0 : 2;
        victim.positionInScan = {4.0, 0.0, 0.0};
        if (number == 3) victim.status = FindSample::Status::Discarded;
        add(victim);
    }
    const Pose first = fold.state().keyScans->at(1).pose.scanInMap;
    const Pose second = fold.state().keyScans->at(2).pose.scanInMap;
    const auto shifted =
        findsMovedBy(fold.state(), {{1, first}, {2, Pose(Eigen::Translation3d(0.3, 0, 0)) * second}}, 0.05);
    ASSERT_THAT(shifted, SizeIs(1));
    EXPECT_EQ(shifted.front().second, 2U);
    EXPECT_THAT(findsMovedBy(fold.state(), {{2, second * poseFrom({0, 0, 0}, 0, 0, 0.02)}}, 0.05), SizeIs(1))
        << "the scan only turns: what is 4 m off moves by 8 cm";
    EXPECT_THAT(findsMovedBy(fold.state(), {{2, second * poseFrom({0, 0, 0}, 0, 0, 0.01)}}, 0.05), IsEmpty());
}

}  // namespace
}  // namespace leitstand
