#include <gmock/gmock.h>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>

#include "tests/app/window/window_page.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

using test::eventually;
using test::WindowPage;
using test::WindowTest;
using testing::HasSubstr;

class ViewTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        m_page = std::make_unique<WindowPage>();
        m_page->openAndWait({drive()});
    }

    std::unique_ptr<WindowPage> m_page;
};

TEST_F(ViewTest, TickBoxesHideScans) {
    const QImage all = m_page->picture();
    for (int row = 0; row < 3; ++row) m_page->clickTickBox(row);
    EXPECT_THAT(m_page->window().scans().visible(), testing::Each(false));
    const QImage none = m_page->picture();
    EXPECT_NE(all, none);
    m_page->clickTickBox(1);
    EXPECT_NE(m_page->picture(), none);
}

TEST_F(ViewTest, LooksAreChosenByToolsAndKeys) {
    const QImage points = m_page->picture();
    m_page->click("tool_lookVoxels");
    EXPECT_EQ(m_page->map().settings().look, MapLook::Voxels);
    EXPECT_NE(m_page->picture(), points);
    m_page->press(Qt::Key_3);
    EXPECT_EQ(m_page->map().settings().look, MapLook::Top);
    EXPECT_TRUE(m_page->find<QAbstractButton>("tool_lookTop").isChecked());
    EXPECT_FALSE(m_page->find<QAbstractButton>("tool_lookVoxels").isChecked());
    m_page->press(Qt::Key_1);
    EXPECT_EQ(m_page->map().settings().look, MapLook::Points);
}

TEST_F(ViewTest, VoxelsHaveAnEdgeToChoose) {
    auto& edge = m_page->find<QDoubleSpinBox>("voxelEdge");
    EXPECT_FALSE(edge.isVisible());
    m_page->press(Qt::Key_2);
    ASSERT_TRUE(edge.isVisible());
    const QImage fine = m_page->picture();
    edge.setFocus();
    edge.selectAll();
    QTest::keyClicks(&edge, QStringLiteral("40"));
    QTest::keyClick(&edge, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(m_page->map().settings().voxelSize, 0.4);
    EXPECT_NE(m_page->picture(), fine);
}

TEST_F(ViewTest, ColoursTellLabelScanHeightOrRange) {
    const QImage labels = m_page->picture();
    m_page->press(Qt::Key_2, Qt::ControlModifier);
    EXPECT_EQ(m_page->map().settings().colouring, MapColouring::Scan);
    const QImage scans = m_page->picture();
    EXPECT_NE(scans, labels);
    m_page->press(Qt::Key_3, Qt::ControlModifier);
    EXPECT_EQ(m_page->map().settings().colouring, MapColouring::Height);
    EXPECT_NE(m_page->picture(), scans);
}

TEST_F(ViewTest, BeforeShowsTheStartPosesUntilReleased) {
    const QImage after = m_page->picture();
    m_page->click("before");
    EXPECT_EQ(m_page->map().settings().poses, MapPoses::Guess);
    EXPECT_TRUE(m_page->find<QAbstractButton>("tool_before").isChecked());
    EXPECT_NE(m_page->picture(), after);
    m_page->press(Qt::Key_B);
    EXPECT_EQ(m_page->map().settings().poses, MapPoses::Registered);
}

TEST_F(ViewTest, ClippingByHeightShowsASliceBetweenTwoHeights) {
    const QImage whole = m_page->picture();
    m_page->press(Qt::Key_H);
    auto& low = m_page->find<QDoubleSpinBox>("clipLow");
    ASSERT_TRUE(low.isVisible());
    ASSERT_TRUE(m_page->map().settings().minHeight.has_value());
    low.setFocus();
    low.selectAll();
    QTest::keyClicks(&low, QStringLiteral("-0.5"));
    QTest::keyClick(&low, Qt::Key_Return);
    EXPECT_NEAR(*m_page->map().settings().minHeight, -0.5, 1e-9);
    EXPECT_THAT(low.text().toStdString(), HasSubstr("−0.5"));
    EXPECT_NE(m_page->picture(), whole);
    m_page->press(Qt::Key_H);
    EXPECT_FALSE(m_page->map().settings().minHeight.has_value());
    EXPECT_FALSE(low.isVisible());
}

TEST_F(ViewTest, TwoClicksMeasureAndEscapeEnds) {
    m_page->press(Qt::Key_M);
    EXPECT_THAT(m_page->label("measurement"), HasSubstr("Click two points"));
    const auto& scan = m_page->window().scans().map()->scans.front();
    std::vector<Eigen::Vector3d> ends;
    // Two points that can be seen: clicking where they are drawn picks something there.
    for (std::size_t i = 0; i < scan.scan->points.size() && ends.size() < 2; i += 101) {
        const Eigen::Vector3d point = scan.poseInMap * scan.scan->points[i].cast<double>();
        if (!point.allFinite()) continue;
        const auto at = m_page->map().project(point);
        if (!at || !m_page->map().rect().contains(at->toPoint())) continue;
        const auto picked = m_page->map().pick(at->toPoint());
        const bool apart = ends.empty() || (picked && (picked->pointInMap - ends[0]).norm() > 1.0);
        if (!picked || !apart) continue;
        QTest::mouseClick(&m_page->map(), Qt::LeftButton, {}, at->toPoint());
        ends.push_back(picked->pointInMap);
    }
    ASSERT_EQ(ends.size(), 2u);
    const auto measurement = m_page->map().measurement();
    ASSERT_TRUE(measurement.has_value());
    EXPECT_NEAR((measurement->to - measurement->from).norm(), (ends[1] - ends[0]).norm(), 0.01);
    EXPECT_THAT(m_page->label("measurement"), testing::MatchesRegex(".* m · dx .* m  dy .* m  dz .* m"));
    m_page->press(Qt::Key_Escape);
    EXPECT_FALSE(m_page->map().measurement().has_value());
    EXPECT_FALSE(m_page->action("measure").isChecked());
    EXPECT_EQ(m_page->label("measurement"), "");
}

TEST_F(ViewTest, ThePointUnderThePointerIsReadOut) {
    const auto& scan = m_page->window().scans().map()->scans.front();
    const auto middle = scan.poseInMap * Eigen::Vector3d(2, 0, -0.9);
    const auto at = m_page->map().project(middle);
    ASSERT_TRUE(at.has_value());
    QTest::mouseMove(&m_page->map(), at->toPoint() + QPoint(40, 0));
    QTest::mouseMove(&m_page->map(), at->toPoint());
    EXPECT_TRUE(eventually([&] { return m_page->label("pick").find("scan00") != std::string::npos; }));
    EXPECT_THAT(m_page->label("pick"), HasSubstr(" m · "));
}

TEST_F(ViewTest, CommandsHaveTheKeysThatTheyHaveInEveryWindow) {
    for (const auto& [name, keys, plain] :
         {std::tuple("lookVoxels", "Alt+2", "2"), std::tuple("cameraReset", "Ctrl+Shift+R", "R"),
          std::tuple("clip", "Ctrl+Shift+H", "H"), std::tuple("measure", "Ctrl+Shift+M", "M")}) {
        EXPECT_EQ(m_page->action(name).shortcut().toString().toStdString(), keys);
        EXPECT_TRUE(m_page->action(name).shortcuts().contains(QKeySequence(QLatin1String(plain)))) << name;
    }
    EXPECT_EQ(m_page->find<QDockWidget>("messagesDock").toggleViewAction()->shortcut(),
              QKeySequence(Qt::Key_F4));
}

TEST_F(ViewTest, CamerasLookFromAboveAndFromTheSide) {
    const QImage free = m_page->picture();
    m_page->press(Qt::Key_T);
    const QImage top = m_page->picture();
    EXPECT_NE(top, free);
    m_page->press(Qt::Key_Y);
    EXPECT_NE(m_page->picture(), top);
    m_page->click("tool_cameraReset");
    EXPECT_NE(m_page->picture(), top);
}

TEST_F(ViewTest, TheLightThemeDressesWindowAndMap) {
    const QColor dark = m_page->window().grab().toImage().pixelColor(4, 4);
    m_page->action("themeLight").trigger();
    const QColor light = m_page->window().grab().toImage().pixelColor(4, 4);
    EXPECT_LT(dark.lightness(), 60);
    EXPECT_GT(light.lightness(), 200);
    EXPECT_EQ(m_page->map().settings().theme, Theme::Light);
    EXPECT_EQ(QApplication::palette().color(QPalette::Window), coloursOf(Theme::Light).window);
    EXPECT_GT(m_page->picture().pixelColor(m_page->map().rect().topRight() + QPoint(-5, 5)).lightness(), 200);
}

}  // namespace
}  // namespace leitstand
