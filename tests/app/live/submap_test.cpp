#include <QFrame>
#include <QTableView>
#include <variant>

#include <gtest/gtest.h>

#include "core/event/scan_links.h"
#include "core/mission/state/decision.h"
#include "tests/app/live/map_on_screen.h"

namespace leitstand::test {
namespace {

class SubmapsOnScreen : public LiveMapOnScreen {
protected:
    [[nodiscard]] QFrame& bar() const { return *m_window->findChild<QFrame*>("submapBar"); }
    [[nodiscard]] bool says(const char* text) {
        return soon([&] { return bar().isVisible() && bar().accessibleName().contains(text); });
    }
    /// Drags what is moved from @p from to @p to, in the map.
    void drag(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Qt::KeyboardModifiers keys = {}) {
        ASSERT_TRUE(soon([&] {
            const auto a = map().project(from), b = map().project(to);
            return a && b && map().rect().contains(a->toPoint()) && map().rect().contains(b->toPoint());
        }));
        const QPoint begin = map().project(from)->toPoint(), end = map().project(to)->toPoint();
        QTest::mousePress(&map(), Qt::LeftButton, keys, begin);
        for (const QPoint at : {(begin + end) / 2, end}) {
            QMouseEvent move(QEvent::MouseMove, at, map().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                             keys);
            QCoreApplication::sendEvent(&map(), &move);
        }
        QTest::mouseRelease(&map(), Qt::LeftButton, keys, end);
    }
    [[nodiscard]] std::size_t movedByHand() const {
        std::size_t count = 0;
        const MissionStatePtr mission = station().mission();
        for (const Decision& one : *mission->decisions) {
            const auto* links = std::get_if<ScanLinksSample>(&one.content);
            if (links != nullptr && !one.undone && !links->links.empty() &&
                links->links.front().kind == LinkKind::Operator)
                ++count;
        }
        return count;
    }
};

TEST_F(SubmapsOnScreen, ARunIsDraggedTurnedSnappedLeftThereAndTakenBack) {
    ASSERT_NO_FATAL_FAILURE(mapTwoScans());
    trigger("map.followAbove");
    const auto all = station().mapping().scans()->scans;
    const auto newest = std::find_if(all.rbegin(), all.rend(), [](const auto& one) { return one.counts(); });
    ASSERT_NE(newest, all.rend());
    const Pose before = newest->pose.scanInMap;
    const Eigen::Vector3d here = before.translation();
    trigger("submap.move");
    ASSERT_TRUE(says("seam")) << bar().accessibleName().toStdString();
    EXPECT_TRUE(bar().accessibleName().contains(QString::number(newest->id)));
    EXPECT_TRUE(bar().parentWidget()->rect().contains(bar().geometry())) << "nothing of it is cut";
    const auto seam = [&] { return bar().accessibleName().section(QStringLiteral("seam "), 1); };
    const QString lying = seam();
    drag(here, here + Eigen::Vector3d(0.5, 0.3, 0));
    drag(here + Eigen::Vector3d(1.0, 0.3, 0), here + Eigen::Vector3d(1.0, 0.45, 0), Qt::ShiftModifier);
    EXPECT_TRUE(soon([&] { return countViolet(map()) > 100; })) << "the moved part";
    EXPECT_TRUE(soon([&] { return seam() > lying; }))
        << seam().toStdString() << ", before " << lying.toStdString();
    lookAt("map_submap");
    const QString dragged = seam();
    trigger("submap.snap");
    EXPECT_TRUE(soon([&] { return bar().accessibleName().contains("seam") && seam() < dragged; }))
        << seam().toStdString() << ", dragged " << dragged.toStdString();
    trigger("submap.leave");
    EXPECT_TRUE(soon([&] { return movedByHand() == 1; }))
        << reported() << "\nthe bar: " << bar().accessibleName().toStdString();
    EXPECT_TRUE(soon([&] { return !bar().isVisible() && !map().drawing(); }));
    EXPECT_TRUE(soon([&] { return countViolet(map()) == 0; }));
    const auto off = [&] {
        const auto now = station().mapping().scans()->scans;
        const auto scan =
            std::find_if(now.begin(), now.end(), [&](const auto& one) { return one.id == newest->id; });
        return distanceBetween(scan->pose.scanInMap, before);
    };
    EXPECT_LT(off(), 0.06) << "it lay right before";
    QAction* const undo = m_window->commands().find("scan.undo");
    EXPECT_TRUE(soon([&] { return undo->isEnabled(); }));
    trigger("scan.undo");
    EXPECT_TRUE(soon([&] { return movedByHand() == 0; }));
}

TEST_F(SubmapsOnScreen, WhatDoesNotFitStaysInHand) {
    ASSERT_NO_FATAL_FAILURE(mapTwoScans());
    trigger("map.followAbove");
    const auto all = station().mapping().scans()->scans;
    const auto newest = std::find_if(all.rbegin(), all.rend(), [](const auto& one) { return one.counts(); });
    const Eigen::Vector3d here = newest->pose.scanInMap.translation();
    trigger("submap.move");
    ASSERT_TRUE(says("seam")) << bar().accessibleName().toStdString();
    // A quarter turn: the yellow arena's rooms do not look so.
    drag(here + Eigen::Vector3d(0.8, 0, 0), here + Eigen::Vector3d(0, 0.8, 0), Qt::ShiftModifier);
    trigger("submap.leave");
    EXPECT_TRUE(soon([&] { return m_window->newest().contains("does not fit"); }))
        << m_window->newest().toStdString();
    EXPECT_TRUE(soon([&] { return m_window->commands().find("submap.leave")->isEnabled(); }));
    EXPECT_TRUE(bar().isVisible()) << "it is dragged on from there";
    EXPECT_TRUE(map().drawing());
    EXPECT_EQ(movedByHand(), 0U);
}

TEST_F(SubmapsOnScreen, WhatIsBegunIsLeftByTheRightButtonAndByAnotherGesture) {
    ASSERT_NO_FATAL_FAILURE(mapTwoScans());
    trigger("submap.move");
    ASSERT_TRUE(says("seam"));
    QTest::mouseClick(&map(), Qt::RightButton, {}, map().rect().center());
    EXPECT_FALSE(bar().isVisible());
    EXPECT_FALSE(m_window->commands().find("submap.move")->isChecked());
    EXPECT_FALSE(m_window->commands().find("submap.snap")->isEnabled());
    trigger("submap.move");
    ASSERT_TRUE(says("seam"));
    trigger("map.area");
    EXPECT_FALSE(bar().isVisible());
    EXPECT_TRUE(map().drawing()) << "the area is drawn now";
    EXPECT_EQ(movedByHand(), 0U);
}

}  // namespace
}  // namespace leitstand::test
