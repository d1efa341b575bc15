#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAction>
#include <QLabel>
#include <QTest>

#include "app/window/commands/command_table.h"
#include "app/window/review/review_application.h"
#include "app/window/review/review_window.h"
#include "app/window/review/timeline_feature.h"
#include "app/window/source/review_bridge.h"
#include "tests/app/report/foreign_bag.h"
#include "tests/support/temporary_folder.h"
#include "widgets/timeline/timeline_bar.h"

namespace leitstand::test {
namespace {

template <class Holds>
bool soon(Holds holds) {
    return QTest::qWaitFor(holds, 60'000);
}

TEST(ForeignReviewWindow, MapsWithProgressAndOpensOnAllOfIt) {
    const TemporaryFolder folder;
    const auto bag = folder / "rover";
    ForeignBag(bag).drive();
    Options options;
    options.scans = {bag};
    EXPECT_TRUE(wantsReview(options));
    const auto bridge = ReviewBridge::open(bag).value();
    QStringList reported;
    ReviewWindow window(*bridge, MapViewSettings{});
    QObject::connect(bridge.get(), &ReviewBridge::opening, &window,
                     [&] { reported += window.timeline().bar().accessibleDescription(); });
    window.resize(1280, 800);
    window.show();
    const QAction* const stop = window.commands().find(QStringLiteral("review.stopMapping"));
    ASSERT_NE(stop, nullptr);
    ASSERT_TRUE(soon([&] { return bridge->reviewed() != nullptr; }));
    EXPECT_FALSE(stop->isEnabled()) << "there is nothing left to be stopped";
    EXPECT_GE(reported.filter(QStringLiteral("registers the point clouds")).size(), 3);
    bridge->player().seek(ForeignBag::at(ForeignBag::Steps + 0.9));
    const auto* const title = window.findChild<QLabel*>(QStringLiteral("mapTitle"));
    ASSERT_NE(title, nullptr);
    EXPECT_TRUE(soon([&] { return title->text().contains(QStringLiteral("7 key scans")); }))
        << title->text().toStdString();
    EXPECT_TRUE(soon([&] { return window.missing().isEmpty(); })) << window.missing().toStdString();
}

}  // namespace
}  // namespace leitstand::test
