// A robot's own grid over the map.
#include "widgets/map_view/overlays/floor/grid_overlay.h"

#include <gtest/gtest.h>
#include <QPainter>

#include "core/event/map_samples.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

constexpr QSize Size(900, 600);

/// 200 x 100 cells of 5 cm from (-5, -2.5): left half free, then half free, unknown on the right, one wall.
RobotGrid grid() {
    OccupancyGridSample grid;
    grid.resolution = 0.05;
    grid.width = 200;
    grid.height = 100;
    grid.cells.resize(20'000);
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        const auto column = i % 200, row = i / 200;
        grid.cells[i] = std::int8_t(column < 100 ? 0 : column < 150 ? 50 : -1);
        if (row >= 90) grid.cells[i] = 100;  // from y = 2 on
    }
    return {.grid = latestPtr(Latest<OccupancyGridSample>{1, {}, std::move(grid)}),
            .gridInMap = poseFrom({-5.0, -2.5, 0.0}, 0, 0, 0),
            .robotPlace = 1,
            .title = QStringLiteral("TurtleBot 4: /map")};
}

class GridOnTheFloor : public testing::TestWithParam<Theme> {
protected:
    /// What is painted for @p camera on nothing.
    QImage painted(const MapCamera& camera) {
        QImage picture(Size, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        m_overlay.paint(painter, MapProjection(camera, Size), m_style);
        return picture;
    }
    static MapCamera fromAbove() {
        MapCamera camera;
        camera.parallel = true;
        camera.pitch = 1.5707;
        camera.distance = 16.0;
        return camera;
    }
    static QColor at(const QImage& picture, const MapCamera& camera, double x, double y) {
        return picture.pixelColor(MapProjection(camera, Size).project({x, y, 0.0})->position.toPoint());
    }

    const OverlayStyle m_style{mapColours(GetParam()), &coloursOf(GetParam()), QFont(), QLocale::c()};
    GridOverlay m_overlay;
};

TEST_P(GridOnTheFloor, OccupiedCellsAreStrongFreeOnesFaintUnknownOnesAreNotPainted) {
    EXPECT_TRUE(m_overlay.setGrid(grid()));
    const MapCamera camera = fromAbove();
    const QImage picture = painted(camera);
    const auto alpha = [&](double x, double y) { return at(picture, camera, x, y).alpha(); };
    EXPECT_GT(alpha(-2.5, 0.0), 20);
    EXPECT_LT(alpha(-2.5, 0.0), 80);
    EXPECT_GT(alpha(1.0, 0.0), 100);
    EXPECT_LT(alpha(1.0, 0.0), 180);
    EXPECT_GT(alpha(0.0, 2.2), 200);
    EXPECT_EQ(alpha(4.0, 0.0), 0) << "unknown";
    EXPECT_EQ(alpha(5.5, 0.0), 0) << "outside";
    EXPECT_EQ(alpha(0.0, 3.0), 0) << "outside";
    const QColor wall = at(picture, camera, 0.0, 2.2), robot = coloursOf(GetParam()).robot(1);
    EXPECT_NEAR(wall.hue(), robot.hue(), 4);
}

TEST_P(GridOnTheFloor, LiesAlsoWhereACameraStandsInIt) {
    m_overlay.setGrid(grid());
    MapCamera camera;  // its eye is above the grid, which is behind it, too
    camera.pitch = 0.4;
    camera.distance = 3.0;
    const QImage picture = painted(camera);
    EXPECT_GT(at(picture, camera, 0.5, 0.0).alpha(), 100);
    EXPECT_GT(at(picture, camera, 1.5, 2.2).alpha(), 200);
    EXPECT_EQ(at(picture, camera, 3.5, 0.0).alpha(), 0) << "unknown";
}

TEST_P(GridOnTheFloor, OnlyWhatLooksDifferentIsPaintedAnew) {
    RobotGrid one = grid();
    EXPECT_TRUE(m_overlay.setGrid(one));
    one.gridInMap.translation().x() += 0.002;
    EXPECT_FALSE(m_overlay.setGrid(one));
    one.gridInMap.translation().x() += 1.0;
    EXPECT_TRUE(m_overlay.setGrid(one));
    const MapCamera camera = fromAbove();
    EXPECT_EQ(at(painted(camera), camera, -4.5, 0.0).alpha(), 0) << "it lies further on now";
    EXPECT_TRUE(m_overlay.setGrid(std::nullopt));
    EXPECT_FALSE(m_overlay.setGrid(std::nullopt));
    EXPECT_EQ(at(painted(camera), camera, -2.5, 0.0).alpha(), 0);
}

TEST_P(GridOnTheFloor, ItsLegendNamesTheRobotAndItsTopic) {
    useTheme(GetParam());
    QImage picture(Size, QImage::Format_RGB32);
    picture.fill(asColour(m_style.colours.background));
    QPainter painter(&picture);
    const QRect below(12, 540, 100, 30);
    paintGridLegend(painter, grid(), Size, below, m_style);
    painter.end();
    const QRect above(0, 0, Size.width(), below.top());
    EXPECT_GT(countOf(picture.copy(above), coloursOf(GetParam()).robot(1), 60), 100)
        << "the square of a wall";
    EXPECT_EQ(
        countOf(picture.copy(QRect(0, below.top(), Size.width(), 60)), coloursOf(GetParam()).robot(1), 60),
        0);
}

INSTANTIATE_TEST_SUITE_P(Themes, GridOnTheFloor, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
