#include "app/window/review/by_hand/by_hand.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <QAction>
#include <QApplication>
#include <QFrame>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>

#include "app/language/language.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/review_log.h"
#include "app/window/commands/command_table.h"
#include "app/window/review/by_hand/by_hand_bridge.h"
#include "app/window/review/by_hand/by_hand_window.h"
#include "core/mapping/live/loops/submap.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/cut_texts.h"
#include "tests/app/review/written_room.h"
#include "tests/app/window_size.h"
#include "tests/support/temporary_folder.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/map_decisions/decisions_panel.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/points/map_colours.h"

namespace leitstand::test {
namespace {

/// The window on the map of a mission that drifted, as somebody corrects it.
class ByHandPage : public testing::Test {
protected:
    ~ByHandPage() override { useLanguage(QStringLiteral("en")); }
    void SetUp() override {
        WrittenMission mission(folder());
        double seconds = 1.0;
        writeDriftedRoom(mission, seconds);
    }
    void open(Theme theme = Theme::Dark) {
        auto bridge = ByHandBridge::open(folder());
        ASSERT_TRUE(bridge) << bridge.error().text;
        m_bridge = std::move(bridge).value();
        MapViewSettings view;
        view.theme = theme;
        m_window = std::make_unique<ByHandWindow>(*m_bridge, view);
        m_window->resize(windowSize());
        m_window->show();
        m_window->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
        ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
    }
    template <class Holds>
    [[nodiscard]] static bool soon(Holds holds) {
        return QTest::qWaitFor(holds, 60'000);
    }
    [[nodiscard]] std::filesystem::path folder() const { return m_folder / "mission"; }
    void trigger(const char* id) {
        QAction* const action = m_window->commands().find(id);
        ASSERT_NE(action, nullptr) << id;
        ASSERT_TRUE(soon([&] { return action->isEnabled(); })) << id;
        action->trigger();
    }
    [[nodiscard]] MapView& map() const { return m_window->mapView(); }
    [[nodiscard]] QString bar() const { return m_window->findChild<QFrame*>("submapBar")->accessibleName(); }
    [[nodiscard]] Pose poseOf(std::uint64_t scan) const {
        const LiveMapPtr map = m_bridge->hand().mapping().scans();
        return std::find_if(map->scans.begin(), map->scans.end(),
                            [&](const LiveKeyScan& one) { return one.id == scan; })
            ->pose.scanInMap;
    }
    void drag(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        ASSERT_TRUE(soon([&] {
            const auto a = map().project(from), b = map().project(to);
            return a && b && map().rect().contains(a->toPoint()) && map().rect().contains(b->toPoint());
        }));
        const QPoint begin = map().project(from)->toPoint(), end = map().project(to)->toPoint();
        QTest::mousePress(&map(), Qt::LeftButton, {}, begin);
        QMouseEvent move(QEvent::MouseMove, end, map().mapToGlobal(end), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&map(), &move);
        QTest::mouseRelease(&map(), Qt::LeftButton, {}, end);
    }
    /// Pixels of the map in the hue of what is moved.
    [[nodiscard]] int violet() const {
        const Rgba hue = mapColours(map().settings().theme).scanInQuestion;
        return countOf(map().grab().toImage(), QColor(hue.r, hue.g, hue.b), 0);
    }
    void lookAt(const QString& name) {
        const QString pictures = qEnvironmentVariable("LEITSTAND_PICTURES");
        if (!pictures.isEmpty()) m_window->grab().save(pictures + "/by_hand_" + name + ".png");
    }
    /// How far the last scan lies from where it was taken, by the first one, in the mission [m].
    [[nodiscard]] double error() const {
        const auto log = ReviewLog::open(folder()).value();
        const auto poses = posesOf(log->stateAt(log->last()));
        const Pose right =
            poses.front().scanInMap * driftedPlace(0).inverse() * driftedPlace(DriftedPlaces - 1);
        return distanceBetween(poses.back().scanInMap, right);
    }

    const TemporaryFolder m_folder;
    std::unique_ptr<ByHandBridge> m_bridge;
    std::unique_ptr<ByHandWindow> m_window;
};

TEST_F(ByHandPage, APartIsDraggedSnappedAndLeftWhereItBelongs) {
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_GT(error(), 0.4);
    lookAt("begins");
    trigger("map.followAbove");
    m_window->findChild<DecisionsPanel*>()->choose(DriftedFrom + 1);
    trigger("submap.move");
    ASSERT_TRUE(soon([&] { return bar().contains("seam"); })) << bar().toStdString();
    const Eigen::Vector3d here = poseOf(DriftedFrom + 1).translation();
    drag(here, here + Eigen::Vector3d(0.1, -0.35, 0));
    EXPECT_TRUE(soon([&] { return violet() > 100; })) << "the moved part";
    lookAt("dragged");
    const auto seam = [&] { return bar().section(QStringLiteral("seam "), 1); };
    ASSERT_TRUE(soon([&] { return bar().contains("seam"); }));
    const QString dragged = seam();
    trigger("submap.snap");
    EXPECT_TRUE(soon([&] { return bar().contains("seam") && seam() < dragged; }))
        << seam().toStdString() << ", dragged " << dragged.toStdString();
    trigger("submap.leave");
    const auto aside = [&] {
        return std::abs((poseOf(1).inverse() * poseOf(DriftedPlaces)).translation().y());
    };
    EXPECT_TRUE(soon([&] { return aside() < 0.05; })) << m_window->newest().toStdString();
    EXPECT_TRUE(soon([&] { return violet() == 0 && m_window->missing().isEmpty(); }));
    lookAt("left");
    m_window.reset();
    ASSERT_TRUE(m_bridge->hand().close());
    EXPECT_LT(error(), 0.03);
}

TEST_F(ByHandPage, IsLeftForTheReviewByACommandWhichWaitsUntilTheMapFollows) {
    QTimer user;
    bool rejected = false;
    QObject::connect(&user, &QTimer::timeout, [&] {
        for (QWidget* one : QApplication::topLevelWidgets()) {
            auto* const window = qobject_cast<ByHandWindow*>(one);
            if (window == nullptr || !window->isVisible()) continue;
            if (!rejected && window->missing().isEmpty()) {
                rejected = true;
                window->findChild<DecisionsPanel*>()->choose(DriftedPlaces);
                window->commands().trigger(QStringLiteral("scan.reject"));
                window->commands().trigger(QStringLiteral("byHand.done"));
            }
        }
    });
    user.start(50);
    QTimer tooLong;  // it never showed its map
    QObject::connect(&tooLong, &QTimer::timeout, [] {
        for (QWidget* one : QApplication::topLevelWidgets()) one->close();
    });
    tooLong.start(60'000);
    const ByHandOutcome outcome = correctByHand(folder());
    EXPECT_TRUE(rejected);
    EXPECT_TRUE(outcome.decided) << outcome.text.toStdString();
    const auto log = ReviewLog::open(folder()).value();
    EXPECT_EQ(log->stateAt(log->last()).keyScans->at(DriftedPlaces).pose.trust, ScanTrust::SetAside);
}

TEST_F(ByHandPage, TellsWhyAMapCannotBeOpened) {
    const ByHandOutcome outcome = correctByHand(m_folder / "none");
    EXPECT_FALSE(outcome.decided);
    EXPECT_TRUE(outcome.text.contains("none")) << outcome.text.toStdString();
}

TEST_F(ByHandPage, FitsInEveryLanguageAndBothThemes) {
    for (const char* code : {"en", "de", "ja"}) {
        useLanguage(QString::fromLatin1(code));
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            m_window.reset();
            m_bridge.reset();
            ASSERT_NO_FATAL_FAILURE(open(theme));
            m_window->findChild<DecisionsPanel*>()->choose(DriftedFrom + 1);
            trigger("submap.move");
            ASSERT_TRUE(soon([&] { return violet() > 100 && bar().count('\n') == 1; }));
            EXPECT_EQ(m_window->size(), windowSize());
            EXPECT_EQ(cutTexts(*m_window).join(QStringLiteral("; ")).toStdString(), "") << code;
            lookAt(QStringLiteral("%1_%2").arg(code, theme == Theme::Dark ? "dark" : "light"));
        }
    }
}

}  // namespace
}  // namespace leitstand::test
