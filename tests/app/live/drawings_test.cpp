// What a stock robot draws, over the live map.
#include <memory>
#include <string>
#include <vector>

#include <QAction>

#include <gtest/gtest.h>

#include "app/window/commands/command_table.h"
#include "core/event/map_samples.h"
#include "core/event/stream_role.h"
#include "tests/app/live/stock_page.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/encode.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

class DrawingsPage : public StockPage {
protected:
    /// Pixels of the map in the colour that the markers below have.
    [[nodiscard]] int violet() const {
        const QImage image = m_window->mapView().grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                count += pixel.red() > 200 && pixel.green() < 40 && pixel.blue() > 200 ? 1 : 0;
            }
        }
        return count;
    }
    /// A box and a word ahead of the robot.
    static MarkersSample ahead() {
        MarkersSample sample;
        Marker& box = sample.markers.emplace_back();
        box.header.frame = "base_link";
        box.space = "test";
        box.id = 1;
        box.markerInFrame = poseFrom({1.2, 0.0, 0.25}, 0.0, 0.0, 0.3);
        box.size = {0.6, 0.4, 0.5};
        box.colour = {1.0F, 0.0F, 1.0F, 1.0F};
        Marker word = box;
        word.id = 2;
        word.shape = MarkerShape::Text;
        word.text = "crate";
        sample.markers.push_back(word);
        return sample;
    }
};

TEST_F(DrawingsPage, LieWhereTheRobotSaysUntilTheyAreRemovedOrHidden) {
    ASSERT_TRUE(soon([&] { return isPlaced(); }));
    EXPECT_EQ(violet(), 0);
    const auto node = nodeIn(m_domain);
    const StreamDescription markers = *station().robots().front().stream(StreamRole::Markers);
    const auto painter = must(node->publisher({markers.topic, markers.type, markers.qos}));
    EXPECT_TRUE(soon([&] {
        (void)painter->write(must(encode(ahead(), markers.type)));
        QTest::qWait(100);
        return violet() > 100;
    }));
    lookAt("drawings");
    QAction* const shown = m_window->commands().find(QStringLiteral("map.drawings"));
    shown->trigger();
    EXPECT_TRUE(soon([&] { return violet() == 0; })) << "hidden";
    shown->trigger();
    EXPECT_TRUE(soon([&] { return violet() > 100; }));
    MarkersSample none;
    none.replacesAll = true;
    (void)painter->write(must(encode(none, markers.type)));
    EXPECT_TRUE(soon([&] { return violet() == 0; })) << "removed";
}

}  // namespace
}  // namespace leitstand::test
