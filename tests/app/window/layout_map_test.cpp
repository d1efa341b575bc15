#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QLineF>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/panes/map/map_feature.h"
#include "core/io/settings/layout_file.h"
#include "tests/app/review/written_mission.h"
#include "tests/app/window/review_page.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

constexpr double Near = 6.0;  ///< on screen [px]

/// How the map is looked at in the layouts of a window.
class LayoutMapTest : public ReviewPage {
protected:
    void use(const char* layout) {
        ASSERT_TRUE(m_window->layouts().use(QLatin1String(layout))) << m_window->newest().toStdString();
        EXPECT_TRUE(soon([this] { return map().settled(); })) << layout;
    }
    void trigger(const char* id) {
        QAction* const command = m_window->commands().find(QLatin1String(id));
        ASSERT_NE(command, nullptr) << id;
        command->trigger();
    }
    /// An own layout of that text.
    void write(const char* name, const std::string& text) {
        std::filesystem::create_directories(m_folder / "layouts");
        writeText(m_folder / "layouts" / (std::string(name) + ".yaml"), text);
    }
    [[nodiscard]] MapView& map() const { return m_window->mapView(); }
    [[nodiscard]] MapSight sight() const { return {map().settings().look, map().settings().follow}; }
    /// Where the robot is in the map at the moment that is shown.
    [[nodiscard]] Pose robot() const {
        for (const RobotInMap& one : *m_bridge->moment().places) {
            if (one.robot == "kurt3d" && one.placed) return one.baseInMap;
        }
        ADD_FAILURE() << "it is not in the map";
        return Pose::Identity();
    }
    [[nodiscard]] QPointF onScreen(const Eigen::Vector3d& place) const {
        return map().project(place).value_or(QPointF(-1e6, -1e6));
    }
    [[nodiscard]] double apart(const QPointF& a, const QPointF& b) const { return QLineF(a, b).length(); }

    static constexpr MapSight HeadingUp{MapLook::Top, MapFollow::Above},
        Overview{MapLook::Points, MapFollow::Free};
};

TEST_F(LayoutMapTest, DriveFollowsTheSelectedRobotFromAboveItsHeadingUp) {
    goTo(10.0);
    use("drive");
    EXPECT_EQ(sight(), HeadingUp);
    EXPECT_TRUE(m_window->commands().find("map.followAbove")->isChecked());
    EXPECT_TRUE(m_window->commands().find("lookTop")->isChecked());
    const QPointF here = onScreen(robot().translation());
    const QPointF ahead = onScreen(robot() * Eigen::Vector3d(1, 0, 0));
    EXPECT_TRUE(map().rect().contains(here.toPoint()));
    EXPECT_NEAR(ahead.x(), here.x(), Near);
    EXPECT_LT(ahead.y(), here.y() - Near);
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("follows K") != std::string::npos; }))
        << label("mapTitle");
    const Pose before = robot();
    goTo(35.0);
    EXPECT_TRUE(soon([&] { return apart(onScreen(robot().translation()), here) < Near; }))
        << "the review stands, and the map has gone with it";
    EXPECT_GT(apart(onScreen(before.translation()), here), 2 * Near);
}

TEST_F(LayoutMapTest, ExploreHasTheFreeCameraWhereItWasLeft) {
    goTo(10.0);
    use("explore");
    EXPECT_EQ(sight(), Overview);
    EXPECT_TRUE(m_window->commands().find("map.free")->isChecked());
    map().showPlace({1.5, 0.4, 0.0});
    ASSERT_TRUE(soon([this] { return map().settled(); }));
    const Eigen::Vector3d place(2.0, 1.0, 0.0);
    const QPointF left = onScreen(place);
    goTo(35.0);
    EXPECT_LT(apart(onScreen(place), left), Near) << "it follows nothing";
    // From above and from behind: the second shows points as well.
    for (const bool behind : {false, true}) {
        use("drive");
        if (behind) trigger("map.followBehind"), trigger("lookPoints");
        EXPECT_TRUE(soon([&] { return map().settled() && apart(onScreen(place), left) > Near; }));
        use("explore");
        EXPECT_EQ(sight(), Overview);
        EXPECT_TRUE(soon([&] { return map().settled() && apart(onScreen(place), left) < Near; }))
            << apart(onScreen(place), left) << " px off";
    }
}

TEST_F(LayoutMapTest, ThePointUnderThePointerIsReadOut) {
    goTo(30.0);
    use("explore");
    const MapPtr shown = m_bridge->reviewed()->map;
    ASSERT_TRUE(shown && !shown->scans.empty());
    const std::string usual = label("mapResult");
    std::optional<QPoint> there;  // some point that is in sight
    for (const Eigen::Vector3f& point : shown->scans.front().scan->points) {
        const auto at = map().project(shown->scans.front().poseInMap * point.cast<double>());
        if (!at || !map().rect().adjusted(40, 40, -40, -40).contains(at->toPoint())) continue;
        if (map().pick(at->toPoint())) there = at->toPoint();
        if (there) break;
    }
    ASSERT_TRUE(there);
    QTest::mouseMove(&map(), *there + QPoint(30, 0));
    QTest::mouseMove(&map(), *there);
    EXPECT_TRUE(soon([this] { return label("mapResult").find("x ") == 0; })) << label("mapResult");
    EXPECT_THAT(label("mapResult"), HasSubstr("kurt3d"));
    // A pointer that rests there does not hide that the map is in doubt.
    auto* const feature = m_window->findChild<MapFeature*>();
    ASSERT_NE(feature, nullptr);
    const MapSummary doubt{QStringLiteral("3D map"), QStringLiteral("1 scan does not fit"), Tone::Attention};
    feature->describe([doubt](const LiveMoment&) { return doubt; });
    EXPECT_EQ(label("mapResult"), "1 scan does not fit");
    QTest::mouseMove(&map(), *there + QPoint(30, 0));
    QTest::mouseMove(&map(), *there);
    EXPECT_FALSE(QTest::qWaitFor([this] { return label("mapResult").find("x ") == 0; }, 500));
    feature->describe({});
    EXPECT_TRUE(soon([this] { return label("mapResult").find("x ") == 0; })) << label("mapResult");
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&map(), &leave);
    EXPECT_TRUE(soon([&] { return label("mapResult") == usual; })) << label("mapResult");
}

TEST_F(LayoutMapTest, ALayoutKeepsWhatTheOperatorLastHadThere) {
    use("drive");
    trigger("lookVoxels");
    trigger("map.followBehind");
    use("explore");
    EXPECT_EQ(sight(), Overview);
    use("drive");
    EXPECT_EQ(sight(), (MapSight{MapLook::Voxels, MapFollow::Behind}));
    EXPECT_EQ(m_window->view().look, MapLook::Points) << "what is remembered is not a layout's";
    openWindow();
    use("drive");
    EXPECT_EQ(sight(), HeadingUp) << "for this session only";
}

TEST_F(LayoutMapTest, OwnLayoutsCarryIt) {
    use("drive");
    trigger("lookVoxels");
    trigger("map.followBehind");
    ASSERT_TRUE(m_window->layouts().saveAs(QStringLiteral("From behind")));
    const MapSight saved{MapLook::Voxels, MapFollow::Behind};
    EXPECT_EQ(sight(), saved);
    const auto file = readLayout(m_folder / "layouts" / "from-behind.yaml");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->map.look, saved.look);
    EXPECT_EQ(file->map.follow, saved.follow);
    // Again under the same name: what is saved counts, not what was there before.
    use("explore");
    ASSERT_TRUE(m_window->layouts().saveAs(QStringLiteral("From behind")));
    EXPECT_EQ(sight(), Overview);
    openWindow();
    use("drive");
    use("from-behind");
    EXPECT_EQ(sight(), Overview);
}

TEST_F(LayoutMapTest, TitlesOfAnyScriptAreLayoutsOfTheirOwn) {
    use("drive");
    const QString titles[] = {QStringLiteral("地図"), QStringLiteral("Lager Süd"),
                              QStringLiteral("Lager S d"), QStringLiteral("A b"), QStringLiteral("A-b")};
    std::set<std::string> names;
    for (const QString& title : titles) {
        ASSERT_TRUE(m_window->layouts().saveAs(title)) << title.toStdString();
        EXPECT_EQ(m_window->layouts().current().title, title.toStdString());
        EXPECT_TRUE(names.insert(m_window->layouts().current().name).second) << title.toStdString();
    }
    ASSERT_TRUE(m_window->layouts().saveAs(titles[1]));
    EXPECT_TRUE(names.contains(m_window->layouts().current().name)) << "again: the same file";
}

TEST_F(LayoutMapTest, KeysOfALayoutThatAreTakenAreRefusedAndTold) {
    use("drive");
    const auto keysOf = [&](const char* id) {
        return m_window->commands().find(QLatin1String(id))->shortcut().toString().toStdString();
    };
    const std::string arrange = keysOf("layout.arrange"), swap = keysOf("view.swap");
    ASSERT_TRUE(m_window->layouts().saveAs(QStringLiteral("Own keys")));
    WindowLayout layout = m_window->layouts().current();
    const auto reported = [&](std::map<std::string, std::string> keys) {
        layout.keys = std::move(keys);
        EXPECT_TRUE(saveLayout(layout, m_folder / "layouts" / "own-keys.yaml"));
        QString text;
        const auto received = QObject::connect(m_bridge.get(), &MomentSource::notified,
                                               [&](const QString& reported) { text += reported; });
        use("own-keys");
        QObject::disconnect(received);
        return text.toStdString();
    };
    EXPECT_THAT(reported({{"layout.arrange", "Ctrl+Alt+K"}}), testing::IsEmpty());
    EXPECT_EQ(keysOf("layout.arrange"), "Ctrl+Alt+K");
    for (const std::string& taken :
         {swap, std::string("W"), std::string("Space"), std::string("Esc"), std::string("no such key")}) {
        EXPECT_THAT(reported({{"layout.arrange", taken}}), testing::HasSubstr("layout.arrange: " + taken));
        EXPECT_EQ(keysOf("layout.arrange"), arrange) << taken;
        EXPECT_EQ(keysOf("view.swap"), swap) << taken;
    }
    EXPECT_THAT(reported({{"layout.arrange", swap}, {"view.swap", "Ctrl+Alt+M"}}), testing::IsEmpty());
    EXPECT_EQ(keysOf("layout.arrange"), swap) << "which is free then";
    EXPECT_EQ(keysOf("view.swap"), "Ctrl+Alt+M");
    EXPECT_THAT(reported({{"layout.arrange", ""}}), testing::IsEmpty());
    EXPECT_EQ(keysOf("layout.arrange"), "") << "none is a wish, too";
    use("drive");
    EXPECT_EQ(keysOf("layout.arrange"), arrange) << "and given back";
}

TEST_F(LayoutMapTest, AnOwnDriveThatIsDeletedGivesTheShippedOneBack) {
    use("drive");
    trigger("map.free");
    ASSERT_TRUE(m_window->layouts().saveAs(QStringLiteral("Drive")));
    use("explore");
    use("drive");
    ASSERT_EQ(sight(), (MapSight{MapLook::Top, MapFollow::Free}));
    trigger("layout.forget");
    EXPECT_EQ(m_window->layouts().current().name, "drive");
    EXPECT_EQ(sight(), HeadingUp);
}

TEST_F(LayoutMapTest, AFileThatSaysNothingLeavesTheMapAsItIs) {
    write("plain", "panes:\n  horizontal: [{pane: map}, {pane: camera}]\n");
    use("drive");
    use("plain");
    EXPECT_EQ(sight(), HeadingUp);
    use("explore");
    use("plain");
    EXPECT_EQ(sight(), Overview);
    use("drive");
    ASSERT_TRUE(m_window->layouts().begin(QStringLiteral("plain")));
    EXPECT_EQ(sight(), Overview) << "as a window's first, it has nothing of the layout before";
}

TEST_F(LayoutMapTest, ALookThatIsAskedForIsThatOfTheLayoutInUse) {
    use("drive");
    m_window->setLook(MapLook::Voxels);
    EXPECT_EQ(sight(), (MapSight{MapLook::Voxels, MapFollow::Above}));
    use("explore");
    EXPECT_EQ(sight(), Overview);
    m_window->setLook(MapLook::Voxels);
    EXPECT_EQ(m_window->view().look, MapLook::Voxels);
}

TEST_F(LayoutMapTest, AWordThatIsNoneIsToldWithItsPlace) {
    write("odd", "panes: {pane: map}\nmap: {follow: up}\n");
    EXPECT_FALSE(m_window->layouts().use(QStringLiteral("odd")));
    const std::string reported = m_window->newest().toStdString();
    EXPECT_THAT(reported, HasSubstr("odd.yaml:2: map.follow: expected free, behind or heading-up"));
    EXPECT_EQ(sight(), Overview);
}

}  // namespace
}  // namespace leitstand::test
