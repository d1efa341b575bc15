#include <gtest/gtest.h>
#include <QComboBox>
#include <QPainter>
#include <QSignalSpy>
#include <QTableView>

#include "tests/core/mission/coverage/search_scene.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/coverage/missed_panel.h"
#include "widgets/map_view/map_camera.h"
#include "widgets/map_view/overlays/floor_overlay.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/models/coverage/floor_tint.h"
#include "widgets/theme.h"

namespace leitstand::test {
namespace {

CoverageMapPtr searched() {
    SearchBook book;
    book.add(SearchScene{}.scan());
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, 0.0)));
    return book.coverage(SearchScene::trail());
}

class MissedPanes : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
    [[nodiscard]] QString named(const char* what) const {
        return QStringLiteral("missed_%1_%2")
            .arg(QString::fromLatin1(what),
                 GetParam() == Theme::Dark ? QStringLiteral("dark") : QStringLiteral("light"));
    }
};

TEST_P(MissedPanes, TheListIsReadWholeAndTheSensorIsTheOperators) {
    MissedPanel panel;
    EXPECT_EQ(panel.sensor(), SearchSensor::Camera);
    panel.show(searched(), poseFrom({-2.0, 0.0, 0.0}, 0, 0, 0));
    EXPECT_FALSE(panel.chosen());
    panel.chooseFirst();
    ASSERT_TRUE(panel.chosen());
    EXPECT_EQ(panel.chosen()->number, 1);
    (void)pictureOf(panel, {420, 220}, named("list"));
    panel.show(searched(), poseFrom({-1.0, 0.5, 0.0}, 0, 0, 1.0));
    ASSERT_TRUE(panel.chosen()) << "a choice stays while the robot drives";
    panel.show(nullptr, std::nullopt);
    EXPECT_FALSE(panel.chosen());
    (void)pictureOf(panel, {420, 220}, named("calm"));
}

TEST_P(MissedPanes, TheFloorIsTintedWhereSeenAndHatchedWhereMissed) {
    const FloorTint tint = floorTintOf(*searched(), SearchSensor::Camera);
    QImage picture(900, 600, QImage::Format_RGB32);
    const ThemeColours& colours = coloursOf(GetParam());
    const OverlayStyle style{mapColours(GetParam()), &colours, QFont(), QLocale::c()};
    picture.fill(asColour(style.colours.background));
    MapCamera camera;
    camera.parallel = true;
    camera.pitch = 1.5707;
    camera.distance = 16.0;
    {
        QPainter painter(&picture);
        const MapProjection projection(camera, picture.size());
        paintFloorTint(painter, projection, tint, style);
        paintFloorLegend(painter, tint, picture.size(), {}, style);
        const auto at = [&](double x, double y) {
            return picture.pixelColor(projection.project({x, y, 0.0})->position.toPoint());
        };
        const QColor none = asColour(style.colours.background);
        EXPECT_NE(at(0.0, 0.0), none);
        EXPECT_NE(at(2.0, 0.0), none) << "missed behind the wall";
        EXPECT_NE(at(0.0, 0.0), at(2.0, 0.0));
        EXPECT_EQ(at(3.5, -1.5), none) << "nobody can come there";
    }
    EXPECT_GT(countOf(picture, colours.attention, 60), 200) << "the hatch";
    const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
    if (!folder.isEmpty()) picture.save(folder + QLatin1Char('/') + named("floor") + QStringLiteral(".png"));
}

INSTANTIATE_TEST_SUITE_P(Themes, MissedPanes, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
