#include "app/window/frame/pane_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

PaneSplit pane(const char* id, double share = 1.0) {
    return {.pane = id, .share = share};
}

/// Camera left of (map above scan), all above the strip.
WindowLayout layout() {
    const PaneSplit side{.share = 1.0, .vertical = true, .parts = {pane("map"), pane("scan")}};
    const PaneSplit upper{.share = 3.0, .parts = {pane("camera", 2.0), side}};
    return {.name = "test", .title = "Test", .panes = {.vertical = true, .parts = {upper, pane("strip")}}};
}

class PaneDocksTest : public testing::Test {
protected:
    PaneDocksTest() {
        for (const char* id : {"camera", "map", "scan", "strip", "other"}) {
            auto* label = new QLabel(id);
            label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
            m_panes[id] = label;
            m_docks.add(id, id, *label);
        }
        m_docks.resize(1200, 800);
        m_docks.show();
        m_docks.arrange(layout());
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&m_docks));
    }
    [[nodiscard]] QRect place(const char* id) const {
        const QWidget* pane = m_panes.at(id);
        return {pane->mapTo(&m_docks, QPoint()), pane->size()};
    }

    PaneDocks m_docks;
    std::map<QString, QWidget*> m_panes;
};

TEST_F(PaneDocksTest, PanesStandWhereTheLayoutSaysInItsShares) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(place("camera").width() - 800) < 12; }));
    EXPECT_NEAR(place("camera").height(), 600, 12);
    EXPECT_NEAR(place("map").width(), 400, 12);
    EXPECT_NEAR(place("map").height(), 300, 12);
    EXPECT_NEAR(place("scan").top(), 300, 12);
    EXPECT_NEAR(place("strip").width(), 1200, 4);
    EXPECT_FALSE(m_docks.isPaneVisible("other"));
}

TEST_F(PaneDocksTest, SharesHoldWhenTheWindowGrows) {
    m_docks.resize(2400, 1600);
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(place("camera").width() - 1600) < 16; }))
        << place("camera").width();
    EXPECT_NEAR(place("camera").height(), 1200, 16);
}

TEST_F(PaneDocksTest, PanesChangePlacesAndBack) {
    const QRect camera = place("camera"), map = place("map");
    m_docks.swap("camera", "map");
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(place("map").width() - camera.width()) < 12; }));
    EXPECT_NEAR(place("camera").width(), map.width(), 12);
    EXPECT_TRUE(m_docks.isPaneVisible("camera"));
    EXPECT_TRUE(m_docks.isPaneVisible("map"));
    m_docks.swap("camera", "map");
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(place("camera").width() - camera.width()) < 12; }));
}

TEST_F(PaneDocksTest, PanesAreShownAndHiddenAlsoWhileNothingIsArranged) {
    m_docks.visibility("other")->trigger();
    EXPECT_TRUE(m_docks.isPaneVisible("other"));
    m_docks.visibility("map")->trigger();
    EXPECT_FALSE(m_docks.isPaneVisible("map"));
}

TEST_F(PaneDocksTest, APaneThatTheLayoutLacksComesAsATabWhereItFits) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(place("camera").width() - 800) < 12; }));
    auto& other = static_cast<QLabel&>(*m_panes.at("other"));
    other.setMinimumSize(700, 100);  // the strip has room for it; map and scan have less
    const QRect strip = place("strip"), camera = place("camera");
    const auto isBefore = [&](const char* id) { return !m_panes.at(id)->visibleRegion().isEmpty(); };
    m_docks.open("other");
    ASSERT_TRUE(m_docks.isPaneVisible("other"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return isBefore("other") && !isBefore("strip"); }));
    EXPECT_NEAR(place("other").width(), strip.width(), 12) << "in the room of its neighbour";
    EXPECT_GT(place("other").height(), strip.height() - 60) << "but for the tabs";
    EXPECT_NEAR(place("camera").width(), camera.width(), 12) << "the others stay";
    EXPECT_NEAR(place("camera").height(), camera.height(), 60);

    // Behind its neighbour it is brought before it again; hidden, it leaves no tabs.
    m_docks.open("strip");
    EXPECT_TRUE(QTest::qWaitFor([&] { return isBefore("strip") && !isBefore("other"); }));
    m_docks.open("other");
    EXPECT_TRUE(QTest::qWaitFor([&] { return isBefore("other"); }));
    m_docks.visibility("other")->trigger();
    EXPECT_FALSE(m_docks.isPaneVisible("other"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return isBefore("strip"); }));
    m_docks.visibility("other")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return isBefore("other"); })) << "in the same place as before";
    EXPECT_NEAR(place("other").width(), strip.width(), 12);

    m_docks.arrange(layout());
    EXPECT_FALSE(m_docks.isPaneVisible("other"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return isBefore("strip"); }));
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(place("strip").width() - 1200) < 12; }));
    m_docks.keepInSight("strip");
    m_docks.open("other");
    EXPECT_TRUE(QTest::qWaitFor([&] { return isBefore("other"); }));
    EXPECT_TRUE(isBefore("strip")) << "a robot's mode stays in sight, whatever is opened";
    m_docks.open("unknown");
}

TEST_F(PaneDocksTest, AnArrangementComesBack) {
    m_docks.setArranging(true);
    m_docks.visibility("scan")->trigger();
    ASSERT_FALSE(m_docks.isPaneVisible("scan"));
    WindowLayout mine = layout();
    mine.arrangement = m_docks.arrangement();
    m_docks.setArranging(false);
    WindowLayout all = layout();
    all.panes.parts.push_back(pane("other"));
    m_docks.arrange(all);
    ASSERT_TRUE(m_docks.isPaneVisible("scan"));
    ASSERT_TRUE(m_docks.isPaneVisible("other"));
    m_docks.arrange(mine);
    EXPECT_FALSE(m_docks.isPaneVisible("scan"));
    EXPECT_FALSE(m_docks.isPaneVisible("other"));
    EXPECT_TRUE(m_docks.isPaneVisible("map"));
}

TEST_F(PaneDocksTest, PanesThatAreNotHereLeaveTheirRoom) {
    WindowLayout odd = layout();
    odd.panes.parts[0].parts[1].parts[1].pane = "unknown";
    m_docks.arrange(odd);
    EXPECT_FALSE(m_docks.isPaneVisible("scan"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(place("map").height() - 600) < 12; }));
    odd.arrangement = "bm90IGEgc3RhdGU=";  // "not a state"
    m_docks.arrange(odd);
    EXPECT_TRUE(m_docks.isPaneVisible("map"));
}

/// Docks of the panes "map" and "scan", which is called @p id today.
struct Renamed {
    explicit Renamed(const QString& id) {
        docks.add("map", "Map", map);
        docks.add(id, "Scan", scan, id == "scan" ? QString() : QString("scan"));
        docks.resize(1200, 800);
        docks.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&docks));
    }

    PaneDocks docks;
    QWidget& map = *new QLabel("map");
    QWidget& scan = *new QLabel("scan");
};

TEST(PaneDocksFormerId, ALayoutThatNamesAPaneByItsFormerIdShowsIt) {
    Renamed now("surroundings");
    now.docks.arrange({.name = "old", .panes = {.parts = {pane("map", 3.0), pane("scan")}}});
    EXPECT_TRUE(now.docks.isPaneVisible("surroundings"));
    EXPECT_TRUE(now.docks.has("scan"));
    EXPECT_THAT(now.docks.ids(), testing::ElementsAre("map", "surroundings"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(now.scan.width() - 300) < 12; })) << now.scan.width();
}

TEST(PaneDocksFormerId, AnArrangementSavedUnderTheFormerIdIsRestored) {
    Renamed before("scan");
    before.docks.arrange({.name = "old", .panes = {.parts = {pane("scan", 2.0), pane("map")}}});
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(before.scan.width() - 800) < 12; }));
    Renamed now("surroundings");
    now.docks.arrange({.name = "old",
                       .panes = {.parts = {pane("map"), pane("scan")}},
                       .arrangement = before.docks.arrangement()});
    EXPECT_TRUE(now.docks.isPaneVisible("surroundings"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(now.scan.width() - 800) < 12; })) << now.scan.width();
    EXPECT_EQ(now.docks.arrangement(), before.docks.arrangement())
        << "and today's is read by what was before";
}

/// A widget that asks for room, as a sheet.
class Sheet final : public QWidget {
public:
    [[nodiscard]] QSize sizeHint() const override { return {400, 300}; }
};

TEST(PaneDocksFormerId, ASheetOpensInTheRoomOfAHostThatHasAFormerId) {
    Renamed now("surroundings");
    auto& sheet = *new Sheet;
    now.docks.add("form", "Form", sheet);
    now.docks.addSheet("form", {"surroundings"});
    now.docks.arrange({.name = "old", .panes = {.parts = {pane("map", 3.0), pane("surroundings")}}});
    now.docks.open("form");
    // The host has too little room for both: the sheet lies before it, and has all that it needs.
    auto* const form = qobject_cast<QDockWidget*>(sheet.parentWidget());
    auto* const host = qobject_cast<QDockWidget*>(now.scan.parentWidget());
    EXPECT_TRUE(now.docks.tabifiedDockWidgets(form).contains(host));
    EXPECT_TRUE(QTest::qWaitFor([&] { return sheet.width() >= 396; })) << sheet.width();
}

}  // namespace
}  // namespace leitstand::test
