#include <gtest/gtest.h>
#include <QComboBox>
#include <QPainter>
#include <QSignalSpy>
#include <QTableView>

#include "core/mission/coverage/floor_tint.h"
#include "tests/core/mission/coverage/search_scene.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/coverage/missed_panel.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/floor/floor_overlay.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

/// By a camera that looks from (-2, 0) along x, and as far as @p infrared asks for one too, from there.
SearchedFloorPtr searched(bool infrared = false) {
    SearchBook book;
    book.add(SearchScene{}.scan());
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, 0.0)));
    if (infrared) {
        for (double heading = -3.0; heading < 3.0; heading += 0.3)
            EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, heading, degrees(25), SearchSensor::Infrared)));
    }
    return searchedFloorOf(book.byStorey(SearchScene::trail()));
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

TEST_P(MissedPanes, AnotherSensorMissedOtherPieces) {
    MissedPanel panel;
    const SearchedFloorPtr both = searched(true);
    auto* const choice = panel.findChild<QComboBox*>("missedSensor");
    auto* const table = panel.findChild<QTableView*>("missed");
    ASSERT_TRUE(choice != nullptr && table != nullptr);
    const auto listed = [&] { return static_cast<std::size_t>(table->model()->rowCount()); };
    const auto choose = [&](SearchSensor sensor) {
        const int row = choice->findData(static_cast<int>(sensor));
        choice->setCurrentIndex(row);
        emit choice->activated(row);  // as a hand does
    };
    QSignalSpy chosen(&panel, &MissedPanel::sensorChosen);
    for (const SearchSensor sensor : {SearchSensor::Infrared, SearchSensor::Scanner, SearchSensor::Camera}) {
        choose(sensor);
        EXPECT_EQ(panel.sensor(), sensor);
        panel.show(both, std::nullopt);
        EXPECT_EQ(listed(), both->by(sensor).missed.size());
        panel.show(both, poseFrom({-1.0, 0.0, 0.0}, 0, 0, 0));
        EXPECT_EQ(panel.sensor(), sensor) << "what comes new leaves the operator's choice";
    }
    ASSERT_EQ(chosen.count(), 3);
    EXPECT_EQ(chosen.back().front().value<SearchSensor>(), SearchSensor::Camera);
    panel.setSensor(SearchSensor::Infrared);
    EXPECT_EQ(chosen.count(), 3) << "only a hand's choice is told";
}

TEST_P(MissedPanes, AChosenPieceIsLostWhenItWasSearchedAndKeptWhereItGotSmaller) {
    MissedPanel panel;
    QSignalSpy changed(&panel, &MissedPanel::chosenChanged);
    panel.show(searched(), std::nullopt);
    panel.chooseFirst();
    ASSERT_TRUE(panel.chosen());
    EXPECT_GE(changed.count(), 1);
    const Eigen::Vector3d place = panel.chosen()->inMap;

    // The same list with a larger piece before it: the choice goes along with its place.
    auto more = std::make_shared<SearchedFloor>(*searched());
    auto& missed = more->parts[static_cast<std::size_t>(SearchSensor::Camera)].missed;
    MissedRegion far = missed.front();
    far.area += 1.0;
    far.place += Eigen::Vector2d(20.0, 0.0);
    missed.insert(missed.begin(), far);
    panel.show(more, std::nullopt);
    ASSERT_TRUE(panel.chosen());
    EXPECT_EQ(panel.chosen()->number, 2);
    EXPECT_EQ(panel.chosen()->inMap, place);

    // It was searched: nothing is chosen in its stead, and who shows a button for it is told.
    missed.resize(1);
    changed.clear();
    panel.show(more, std::nullopt);
    EXPECT_FALSE(panel.chosen());
    EXPECT_GE(changed.count(), 1);
    panel.chooseFirst();
    ASSERT_TRUE(panel.chosen());
    EXPECT_EQ(panel.chosen()->number, 1);
}

TEST_P(MissedPanes, TheFloorIsTintedWhereSeenAndHatchedWhereMissed) {
    FloorOverlay overlay;
    overlay.setTint(tintOf(searched(), SearchSensor::Camera));
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
        overlay.paint(painter, projection, style);
        paintFloorLegend(painter, *overlay.tint(), picture.size(), {}, style);
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
    QImage again(picture.size(), QImage::Format_ARGB32_Premultiplied);
    again.fill(Qt::transparent);
    QPainter painter(&again);
    overlay.paint(painter, MapProjection(camera, again.size()), style);
    EXPECT_EQ(overlay.made(), 1) << "nothing moved";
    EXPECT_GT(qAlpha(again.pixel(MapProjection(camera, again.size()).project({0, 0, 0})->position.toPoint())),
              0)
        << "but it is painted";
    camera.yaw = 0.5;
    overlay.paint(painter, MapProjection(camera, again.size()), style);
    EXPECT_EQ(overlay.made(), 2);
    overlay.setTint(tintOf(searched(true), SearchSensor::Infrared));
    overlay.paint(painter, MapProjection(camera, again.size()), style);
    EXPECT_EQ(overlay.made(), 3);
    overlay.setTint(nullptr);
    overlay.paint(painter, MapProjection(camera, again.size()), style);
    EXPECT_EQ(overlay.made(), 3);
    const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
    if (!folder.isEmpty()) picture.save(folder + QLatin1Char('/') + named("floor") + QStringLiteral(".png"));
}

INSTANTIATE_TEST_SUITE_P(Themes, MissedPanes, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
