#include <string>
#include <vector>

#include <QAction>
#include <QFrame>
#include <QToolButton>

#include <gtest/gtest.h>

#include "app/services/review/map_tidying.h"
#include "app/window/commands/command_table.h"
#include "core/event/station_topics.h"
#include "tests/app/review/written_room.h"
#include "tests/app/window/review_page.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/points/map_colours.h"

namespace leitstand::test {
namespace {

/// The review of a mission whose map lay off by some centimetres until it was tidied.
class TidiedReview : public ReviewPage {
protected:
    void writeMission() override {
        {
            WrittenMission mission(m_mission);
            double seconds = 1.0;
            std::vector<ScanPose> poses = writeRoom(mission, alongTheRoom(), seconds);
            for (std::size_t i = 1; i < poses.size(); ++i)
                poses[i].scanInMap =
                    poses[i].scanInMap * poseFrom({i % 2 == 0 ? 0.12 : -0.12, 0.08, 0}, 0, 0, 0);
            mission.publish(seconds, std::string(station_topic::ScanPoses),
                            ScanPosesSample{Time{}, "us", ScanPosesSample::Cause::Registration, poses});
        }
        const auto tidied = tidyMap(m_mission);
        ASSERT_TRUE(tidied) << tidied.error().text;
        ASSERT_EQ(tidied->moved, 5U);
    }
    [[nodiscard]] int violet() const {
        MapView& map = m_window->mapView();
        const Rgba hue = mapColours(map.settings().theme).scanInQuestion;
        return countOf(map.grab().toImage(), QColor(hue.r, hue.g, hue.b), 0);
    }
};

TEST_F(TidiedReview, TheMapBeforeIsShownOverTheOneAfter) {
    QAction* const before = m_window->commands().find(QStringLiteral("review.beforeTidying"));
    const auto& notice = find<QFrame>("tidyingNotice");
    ASSERT_TRUE(soon([&] { return before->isEnabled(); })) << "the map was tidied";
    EXPECT_FALSE(notice.isVisible());
    EXPECT_EQ(violet(), 0);
    before->trigger();
    EXPECT_TRUE(notice.isVisible());
    EXPECT_TRUE(notice.accessibleName().contains("Scans moved: 5, by up to 0.1"))
        << notice.accessibleName().toStdString();
    EXPECT_TRUE(soon([&] { return violet() > 100; })) << "where scans lay before";
    lookAt("before_tidying");
    find<QToolButton>("button_review.beforeTidying").click();
    EXPECT_FALSE(notice.isVisible());
    EXPECT_TRUE(soon([&] { return violet() == 0; }));
    MapTidying wanted = MapTidying::Tidy;
    QObject::connect(m_window.get(), &ReviewWindow::tidyingWanted, m_window.get(),
                     [&](MapTidying what) { wanted = what; });
    before->trigger();
    find<QToolButton>("button_review.untidy").click();
    EXPECT_EQ(wanted, MapTidying::TakeBack);
}

}  // namespace
}  // namespace leitstand::test
