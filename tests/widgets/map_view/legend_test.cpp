#include "widgets/map_view/overlays/legend.h"

#include <memory>

#include <gtest/gtest.h>
#include <QImage>
#include <QPainter>

#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/scene/scene_content.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

/// A map seen from above, with floor, walls and points of no label.
SceneContent labelledMap() {
    auto points = std::make_shared<ScanPoints>();
    points->labelCounts = {10, 10, 10, 0};
    SceneContent content;
    content.settings.look = MapLook::Top;
    content.scans.emplace_back();
    content.scans.back().points = points;
    return content;
}

/// The box of @p content's legend in a view of @p size, whose scale takes @p taken.
QRect legendOf(const SceneContent& content, QSize size, const QRect& taken) {
    QImage picture(size, QImage::Format_RGB32);
    QPainter painter(&picture);
    const OverlayStyle style{mapColours(Theme::Dark), &coloursOf(Theme::Dark), QFont(), QLocale::c()};
    return paintLegend(painter, content, size, taken, style);
}

TEST(Legend, DrawsItselfInBesideTheScaleBeforeItGoesAboveIt) {
    const SceneContent content = labelledMap();
    const QSize size(900, 240);
    const QRect wide = legendOf(content, size, {700, 200, 180, 30});
    const QRect scale(wide.right(), 200, 180, 30);  // too near for a legend that leaves itself room
    const QRect tight = legendOf(content, size, scale);
    EXPECT_LT(tight.right(), scale.left());
    EXPECT_LT(tight.width(), wide.width());
    EXPECT_EQ(tight.bottom(), wide.bottom()) << "it is still in the corner";
    const QRect above = legendOf(content, size, {wide.left() + 20, 200, 180, 30});
    EXPECT_LT(above.bottom(), 200);
    EXPECT_EQ(above.width(), tight.width());
}

}  // namespace
}  // namespace leitstand::test
