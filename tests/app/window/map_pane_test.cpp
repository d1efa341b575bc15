#include "app/window/map/map_pane.h"

#include <QCoreApplication>
#include <QLabel>

#include <gtest/gtest.h>

#include "app/window/map/view_state.h"

namespace leitstand::test {
namespace {

TEST(MapPane, TellsTheMapInBriefWhereItIsNarrow) {
    ViewState state{MapViewSettings()};
    MapPane pane(state);
    const auto text = [&](const char* name) {
        return pane.findChild<QLabel*>(QLatin1String(name))->text().toStdString();
    };
    MapSummary summary;
    summary.title = QStringLiteral("3D map · 47 key scans · 1.21 M points · follows K");
    summary.briefTitle = QStringLiteral("3D map · 47 key scans · follows K");
    summary.result = QStringLiteral("certain · overlap 83 % · last scan 1.4 s ago");
    summary.briefResult = QStringLiteral("certain · last scan 1.4 s ago");
    pane.resize(1200, 300);
    pane.show();
    pane.setSummary(summary);
    EXPECT_EQ(text("mapTitle"), summary.title.toStdString());
    EXPECT_EQ(text("mapResult"), summary.result.toStdString());
    pane.resize(500, 300);
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(text("mapTitle"), summary.briefTitle.toStdString());
    EXPECT_EQ(text("mapResult"), summary.briefResult.toStdString());
    const auto* const result = pane.findChild<QLabel*>(QStringLiteral("mapResult"));
    EXPECT_LE(result->fontMetrics().horizontalAdvance(result->text()), result->width()) << "nothing is cut";
    EXPECT_TRUE(result->toolTip().contains(QStringLiteral("overlap 83 %"))) << "all of it is in the tooltip";
    pane.resize(1200, 300);
    EXPECT_EQ(text("mapResult"), summary.result.toStdString());
}

}  // namespace
}  // namespace leitstand::test
