#include <limits>

#include <gtest/gtest.h>
#include <QSignalSpy>

#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

/// Points in a wall across the view, some 40 pixels apart.
std::vector<Eigen::Vector3f> gridOfPoints() {
    std::vector<Eigen::Vector3f> points;
    for (float y = -2; y <= 2; y += 0.8F) {
        for (float z = -1; z <= 1; z += 0.5F) points.emplace_back(5.0F, y, z);
    }
    return points;
}

TEST(MapPicking, EveryPointIsFoundWhereItIsDrawn) {
    ShownView view(mapOf(gridOfPoints()));
    const auto expectAllFound = [&view] {
        for (const Eigen::Vector3f& point : gridOfPoints()) {
            const auto picked = view->pick(view.at(point.cast<double>()).toPoint());
            ASSERT_TRUE(picked);
            EXPECT_LT((picked->pointInMap - point.cast<double>()).norm(), 1e-5);
            EXPECT_EQ(picked->scan, 0);
            EXPECT_EQ(picked->label, Label::Wall);
        }
    };
    expectAllFound();
    view.drag(Qt::LeftButton, {240, 150}, {280, 165});
    expectAllFound();
    view.wheel({100, 80}, 2);
    expectAllFound();
}

TEST(MapPicking, FindsThePointWithinEightPixelsAndNothingBeyond) {
    ShownView view(mapOf(gridOfPoints()));
    const QPoint place = view.at(gridOfPoints().front().cast<double>()).toPoint();
    EXPECT_TRUE(view->pick(place + QPoint(5, 4)));
    EXPECT_FALSE(view->pick(place + QPoint(-13, 0)));
    EXPECT_FALSE(view->pick({2, 2}));
}

TEST(MapPicking, TakesTheFrontmostOfPointsBehindEachOther) {
    ShownView view(mapOf({{2, 1, 0}, {2, 1, -3}, {5, -2, 0}, {-1, -2, 0}}), settingsOf(MapLook::Top));
    const auto picked = view->pick(view.at({2, 1, -3}).toPoint());
    ASSERT_TRUE(picked);
    EXPECT_NEAR(picked->pointInMap.z(), 0.0, 1e-6);
}

TEST(MapPicking, KnowsWhichScanAPointIsOf) {
    ShownView view(mapOf({blob({4, 1, 0}, Label::Wall), blob({4, -1, 0}, Label::Floor)}));
    const auto picked = view->pick(view.at({4, -1, 0}).toPoint());
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->scan, 1);
    EXPECT_EQ(picked->label, Label::Floor);
}

TEST(MapPicking, PassesOverWhatIsNotShown) {
    ShownView view(mapOf({blob({4, 1, 0}, Label::Wall), blob({4, -1, 2}, Label::Wall)}));
    EXPECT_TRUE(view->pick(view.at({4, 1, 0}).toPoint()));
    view->setVisible({false, true});
    view.settle();
    EXPECT_FALSE(view->pick(view.at({4, 1, 0}).toPoint()));
    EXPECT_TRUE(view->pick(view.at({4, -1, 2}).toPoint()));
    view.alter([](MapViewSettings& settings) { settings.maxHeight = 1.0; });
    EXPECT_FALSE(view->pick(view.at({4, -1, 2}).toPoint()));
}

TEST(MapPicking, PassesOverNoEchoAndTheRobotItself) {
    constexpr float Nan = std::numeric_limits<float>::quiet_NaN();
    ShownView view(mapOf({{3, 0, 0}, {3, 1, 1}, {0.2F, 0, 0}, {32.76F, 0, 0}, {Nan, Nan, Nan}}));
    EXPECT_TRUE(view->pick(view.at({3, 0, 0}).toPoint()));
    const auto robot = view->pick(view.at({0.2, 0, 0}).toPoint());
    EXPECT_TRUE(!robot || robot->pointInMap.x() > 1);
    const auto echo = view->project({32.76, 0, 0});
    const auto far = echo ? view->pick(echo->toPoint()) : std::nullopt;
    EXPECT_TRUE(!far || far->pointInMap.x() < 4);
}

TEST(MapPicking, HoveringTellsThePointUnderThePointer) {
    ShownView view(mapOf(gridOfPoints()));
    std::vector<std::optional<PickedPoint>> seen;
    QObject::connect(&*view, &MapView::hovered, &*view, [&](const auto& point) { seen.push_back(point); });
    const Eigen::Vector3d point = gridOfPoints()[7].cast<double>();
    view.hover(view.at(point).toPoint());
    ASSERT_TRUE(waitFor([&] { return !seen.empty() && seen.back(); }));
    EXPECT_LT((seen.back()->pointInMap - point).norm(), 1e-5);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&*view, &leave);
    EXPECT_FALSE(seen.back());
}

TEST(MapMeasuring, TwoClicksGiveTheDistanceBetweenTheirPoints) {
    const Eigen::Vector3d from(5, -2, -1), to(5, 2, 1);
    ShownView view(mapOf(gridOfPoints()));
    QSignalSpy measured(&*view, &MapView::measured);
    view->setMeasuring(true);
    view.click(view.at(from).toPoint());
    EXPECT_FALSE(view->measurement());
    view.click(view.at(to).toPoint());
    ASSERT_TRUE(view->measurement());
    EXPECT_EQ(measured.count(), 1);
    EXPECT_NEAR((view->measurement()->to - view->measurement()->from).norm(), (to - from).norm(), 0.01);
    EXPECT_LT((view->measurement()->from - from).norm(), 0.01);
    EXPECT_LT((view->measurement()->to - to).norm(), 0.01);
}

TEST(MapMeasuring, LineIsPaintedAndGoesWithEsc) {
    ShownView view(mapOf(gridOfPoints()));
    view->setMeasuring(true);
    const QImage before = view->picture();
    view.click(view.at({5, -2, -1}).toPoint());
    view.click(view.at({5, 2, 1}).toPoint());
    ASSERT_TRUE(view->measurement());
    EXPECT_NE(view->picture(), before);
    view.press(Qt::Key_Escape);
    EXPECT_FALSE(view->measurement());
    EXPECT_EQ(view->picture(), before);
}

TEST(MapMeasuring, ThirdClickBeginsAnewAndTurningOffForgets) {
    ShownView view(mapOf(gridOfPoints()));
    view->setMeasuring(true);
    view.click(view.at({5, -2, -1}).toPoint());
    view.click(view.at({5, 2, 1}).toPoint());
    view.click(view.at({5, -2, 0}).toPoint());
    EXPECT_FALSE(view->measurement());
    view.click(view.at({5, -2, 1}).toPoint());
    ASSERT_TRUE(view->measurement());
    EXPECT_NEAR((view->measurement()->to - view->measurement()->from).norm(), 1.0, 0.01);
    view->setMeasuring(false);
    EXPECT_FALSE(view->measurement());
}

TEST(MapMeasuring, EndsGoWithTheScansThatHaveTheirPoints) {
    Map map = *mapOf({blob({4, 1, 0}, Label::Wall), blob({4, -1, 0}, Label::Wall)});
    map.scans[0].id = 7;
    map.scans[1].id = 8;
    ShownView view(std::make_shared<const Map>(map));
    view->setMeasuring(true);
    view.click(view.at({4, 1, 0}).toPoint());
    view.click(view.at({4, -1, 0}).toPoint());
    ASSERT_TRUE(view->measurement());
    EXPECT_NEAR((view->measurement()->to - view->measurement()->from).norm(), 2.0, 0.15);
    // A loop closes: the second scan moves, and one came before it.
    map.scans[1].poseInMap = map.scans[1].guessInMap = Pose(Eigen::Translation3d(0, -1, 0));
    map.scans.insert(map.scans.begin(), map.scans.front());
    map.scans.front().id = 3;
    view->setMap(std::make_shared<const Map>(map));
    ASSERT_TRUE(view.settle());
    EXPECT_NEAR((view->measurement()->to - view->measurement()->from).norm(), 3.0, 0.15);
    // The operator rejects it: what was measured stays where it was.
    map.scans.pop_back();
    view->setMap(std::make_shared<const Map>(map));
    ASSERT_TRUE(view.settle());
    ASSERT_TRUE(view->measurement());
    EXPECT_NEAR((view->measurement()->to - view->measurement()->from).norm(), 2.0, 0.15)
        << "as it was picked";
}

TEST(MapMeasuring, DragTurnsTheMapInsteadOfMeasuring) {
    ShownView view(mapOf(gridOfPoints()));
    view->setMeasuring(true);
    const QPoint start = view.at({5, -2, -1}).toPoint();
    view.drag(Qt::LeftButton, start, start + QPoint(60, 0));
    view.click(view.at({5, 2, 1}).toPoint());
    EXPECT_FALSE(view->measurement());
}

TEST(MapMeasuring, ClicksMeasureNothingWhileOff) {
    ShownView view(mapOf(gridOfPoints()));
    view.click(view.at({5, -2, -1}).toPoint());
    view.click(view.at({5, 2, 1}).toPoint());
    EXPECT_FALSE(view->measurement());
}

}  // namespace
}  // namespace leitstand::test
