#include "widgets/map_view/overlays/legend.h"

#include <chrono>
#include <string>

#include <gtest/gtest.h>
#include <QPainter>

#include "tests/widgets/panes/shown.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/scene/scene_content.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

/// A widget that shows a legend alone.
struct Legend : QWidget {
    explicit Legend(const SceneContent& content) : m_content(content) { resize(1200, 200); }
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const OverlayStyle style{mapColours(Theme::Dark), &coloursOf(Theme::Dark), QFont(), QLocale::c()};
        (void)paintLegend(painter, m_content, size(), {width(), 0, 1, 1}, style);
    }

private:
    const SceneContent& m_content;
};

QStringList wordsOf(const SceneContent& content) {
    Legend legend(content);
    QStringList words;
    for (const PaintedText& one : paintedTexts(legend)) words += one.text;
    return words;
}

TEST(MapLegend, NamesScansOfRobotsAsTheirListDoes) {
    SceneContent content;
    content.settings.colouring = MapColouring::Scan;
    content.robots = {{"kurt3d", "Kurt3D", 0, "K"}, {"walker", "Walker", 1, ""}};
    for (std::uint64_t id = 1; id <= 12; ++id) {
        SceneScan& scan = content.scans.emplace_back();
        scan.id = id;
        scan.robotAt = id == 11 ? 1 : 0;
        scan.entered = Time(std::chrono::seconds(100 + id));
    }
    const QStringList words = wordsOf(content);
    ASSERT_EQ(words.size(), 9);
    EXPECT_EQ(words.first(3), QStringList({"K 12", "Walker 11", "K 10"})) << "the newest first";
    EXPECT_EQ(words.last(), "+4");
}

TEST(MapLegend, NamesScansOfFilesByThese) {
    SceneContent content;
    content.settings.colouring = MapColouring::Scan;
    content.robots = {{"", "", -1, ""}};
    for (const char* name : {"scan000", "scan001"}) content.scans.emplace_back().name = name;
    EXPECT_EQ(wordsOf(content), QStringList({"scan000", "scan001"}));
}

}  // namespace
}  // namespace leitstand::test
