#include <limits>

#include <gtest/gtest.h>
#include <QProcess>
#include <QSignalSpy>

#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

/// Two scans with a blob each; before registration the second was a metre farther to the left.
MapPtr twoScans() {
    const MapPtr map = mapOf({blob({4, 1, 0}, Label::Wall), blob({4, -1, 0}, Label::Ceiling)});
    auto guessed = std::make_shared<Map>(*map);
    guessed->scans[1].guessInMap = poseFrom({0, 0.8, 0}, 0, 0, 0);
    return guessed;
}

TEST(MapShowing, EmptyMapIsBackgroundOnly) {
    ShownView view;
    const QImage picture = view->picture();
    EXPECT_EQ(picture.size(), QSize(480, 300));
    EXPECT_EQ(countPixels(picture, DarkBackground, 0), 480 * (300 - 44));
    view->setMap(std::make_shared<const Map>());
    EXPECT_TRUE(view.settle());
    EXPECT_FALSE(view->pick({240, 150}));
}

TEST(MapShowing, MapWithNothingButNoEchoIsNoTrouble) {
    constexpr float Nan = std::numeric_limits<float>::quiet_NaN();
    for (const MapLook look : {MapLook::Points, MapLook::Voxels, MapLook::Top}) {
        ShownView view(mapOf({{Nan, Nan, Nan}, {40, 0, 0}}), settingsOf(look));
        EXPECT_FALSE(view->pick({240, 150}));
        EXPECT_EQ(countPixels(view->picture(), WallYellow), 0);
    }
}

TEST(MapShowing, HiddenScansVanishAndComeBack) {
    ShownView view(twoScans());
    EXPECT_GT(countPixels(view->picture(), CeilingRed), 20);
    view->setVisible({true, false});
    EXPECT_EQ(countPixels(view->picture(), CeilingRed), 0);
    EXPECT_GT(countPixels(view->picture(), WallYellow), 20);
    view->setVisible(std::vector<bool>{true});
    EXPECT_GT(countPixels(view->picture(), CeilingRed), 20);
    view.alter([](MapViewSettings& settings) { settings.look = MapLook::Voxels; });
    view->setVisible({true, false});
    EXPECT_EQ(countPixels(view->picture(), CeilingRed), 0);
}

TEST(MapShowing, GuessShowsWhereScansWereBeforeRegistration) {
    ShownView view(twoScans());
    const auto isThere = [&view](const Eigen::Vector3d& place) {
        return colourAt(view->picture(), view.at(place), DarkBackground) == CeilingRed;
    };
    EXPECT_TRUE(isThere({4, -1, 0}));
    EXPECT_FALSE(isThere({4, -0.2, 0}));
    view.alter([](MapViewSettings& settings) { settings.poses = MapPoses::Guess; });
    EXPECT_TRUE(isThere({4, -0.2, 0}));
    EXPECT_FALSE(isThere({4, -1, 0}));
    view.alter([](MapViewSettings& settings) { settings.look = MapLook::Voxels; });
    EXPECT_NE(colourAt(view->picture(), view.at({4, -0.2, 0}), DarkBackground), DarkBackground);
}

TEST(MapShowing, ScansThatMoveAreDrawnAtTheirNewPlace) {
    const MapPtr before = twoScans();
    auto after = std::make_shared<Map>(*before);
    after->scans[1].poseInMap = poseFrom({0, 0, 0.7}, 0, 0, 0);
    ShownView view(before);
    view->setMap(after);
    view.settle();
    const QImage picture = view->picture();
    EXPECT_EQ(colourAt(picture, view.at({4, -1, 0.7}), DarkBackground), CeilingRed);
    EXPECT_NE(colourAt(picture, view.at({4, -1, 0}), DarkBackground), CeilingRed);
}

TEST(MapShowing, HeightLimitsHideWhatIsBeyond) {
    const MapPtr map = mapOf(
        {blob({4, 1, -1}, Label::Floor), blob({4, 0, 0.5}, Label::Wall), blob({4, -1, 2}, Label::Ceiling)});
    for (const MapLook look : {MapLook::Points, MapLook::Voxels}) {
        MapViewSettings settings = settingsOf(look);
        settings.minHeight = 0.0;
        settings.maxHeight = 1.0;
        ShownView view(map, settings);
        const QImage picture = view->picture();
        EXPECT_EQ(colourAt(picture, view.at({4, 1, -1}), DarkBackground), DarkBackground);
        EXPECT_NE(colourAt(picture, view.at({4, 0, 0.5}), DarkBackground), DarkBackground);
        EXPECT_EQ(colourAt(picture, view.at({4, -1, 2}), DarkBackground), DarkBackground);
    }
}

TEST(MapShowing, RangeLimitsHideWhatIsNearerAndFarther) {
    const MapPtr map = mapOf(
        {blob({1, 0.5, 0}, Label::Floor), blob({5, 1, 0}, Label::Wall), blob({9, -1, 0}, Label::Ceiling)});
    MapViewSettings settings;
    settings.minRange = 2.0;
    settings.maxRange = 7.0;
    ShownView view(map, settings);
    const QImage picture = view->picture();
    EXPECT_EQ(colourAt(picture, view.at({1, 0.5, 0}), DarkBackground), DarkBackground);
    EXPECT_EQ(colourAt(picture, view.at({9, -1, 0}), DarkBackground), DarkBackground);
    EXPECT_EQ(colourAt(picture, view.at({5, 1, 0}), DarkBackground), WallYellow);
}

TEST(MapShowing, ThemeChangesTheBackground) {
    ShownView view(twoScans());
    EXPECT_LT(qGray(view->picture().pixel(3, 3)), 64);
    view.alter([](MapViewSettings& settings) { settings.theme = Theme::Light; });
    EXPECT_GT(qGray(view->picture().pixel(3, 3)), 200);
    EXPECT_GT(countPixels(view->picture(), CeilingRed), 20) << "labels keep their colours";
}

TEST(MapShowing, WhatIsOnScreenIsThePictureOnceItHasSettled) {
    ShownView view(twoScans());
    ASSERT_TRUE(view->settled());
    EXPECT_EQ(view.onScreen().convertToFormat(QImage::Format_RGB32), view->picture());
}

TEST(MapShowing, TellsOnceWhenAPictureIsComplete) {
    ShownView view(twoScans());
    QSignalSpy settled(&*view, &MapView::becameSettled);
    view->setCamera(CameraPreset::Side);
    EXPECT_FALSE(view->settled());
    ASSERT_TRUE(waitFor([&] { return settled.count() > 0; }));
    EXPECT_TRUE(view->settled());
    EXPECT_EQ(settled.count(), 1);
}

TEST(MapShowing, PictureFollowsTheSizeOfTheView) {
    ShownView view(twoScans());
    view->resize(700, 220);
    EXPECT_TRUE(view.settle());
    EXPECT_EQ(view->picture().size(), QSize(700, 220));
    const QRectF inside = view->rect();
    EXPECT_TRUE(inside.contains(view.at({4, 1, 0})) && inside.contains(view.at({4, -1, 0})));
}

TEST(MapShowing, PictureNeedsNoWindowOnScreen) {
    MapView view;
    view.resize(320, 240);
    view.setMap(twoScans());
    EXPECT_GT(countPixels(view.picture(), WallYellow), 20);
}

TEST(MapShowing, ViewThatWasHiddenShowsWhatHappenedMeanwhile) {
    ShownView view(twoScans());
    view->hide();
    view->setVisible({true, false});
    view->show();
    EXPECT_TRUE(view.settle());
    EXPECT_EQ(countPixels(view.onScreen(), CeilingRed), 0);
}

TEST(MapShowing, SeveralViewsShowTheirOwnMaps) {
    ShownView first(mapOf({blob({4, 0, 0}, Label::Floor)}));
    ShownView second(mapOf({blob({4, 0, 0}, Label::Ceiling)}),
                     settingsOf(MapLook::Points, MapColouring::Label, Theme::Light));
    first->setCamera(CameraPreset::Side);
    second->setCamera(CameraPreset::Top);
    EXPECT_TRUE(first.settle() && second.settle());
    EXPECT_GT(countPixels(first->picture(), FloorBlue), 20);
    EXPECT_EQ(countPixels(first->picture(), CeilingRed), 0);
    EXPECT_GT(countPixels(second->picture(), CeilingRed), 20);
    EXPECT_EQ(countPixels(second->picture(), FloorBlue), 0);
}

TEST(MapShowing, ViewsMayGoWhileTheyAreBeingDrawn) {
    const MapPtr map = largeMap(300'000);
    for (const MapLook look : {MapLook::Points, MapLook::Voxels, MapLook::Top}) {
        MapView view;
        view.setSettings(settingsOf(look));
        view.setMap(map);
        view.show();
        view.setCamera(CameraPreset::Side);
        QCoreApplication::processEvents();
    }
    ShownView after(twoScans());
    EXPECT_GT(countPixels(after->picture(), WallYellow), 20);
}

/// Runs the test that calls this again, in a process of its own where @p variable has @p value.
void runApart(const QString& variable, const QString& value) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(variable, value);
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.start(QCoreApplication::applicationFilePath(),
                  {QString("--gtest_filter=%1.%2").arg(test->test_suite_name(), test->name())});
    constexpr int Patience = 60'000;  // [ms]
    ASSERT_TRUE(process.waitForFinished(Patience));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 0);
}

TEST(MapShowing, IsCrispOnDenseScreens) {
    if (qgetenv("QT_SCALE_FACTOR") != "2") return runApart("QT_SCALE_FACTOR", "2");
    ShownView view(twoScans());
    const QImage picture = view->picture();
    EXPECT_EQ(picture.size(), QSize(960, 600));
    EXPECT_EQ(picture.devicePixelRatio(), 2.0);
    EXPECT_EQ(colourAt(picture, view.at({4, 1, 0}), DarkBackground), WallYellow);
    EXPECT_TRUE(view->pick(view.at({4, -1, 0}).toPoint()));
}

TEST(MapShowing, SaysSoWhenNothingCanBeDrawn) {
    constexpr const char* Drivers = "__EGL_VENDOR_LIBRARY_FILENAMES";
    if (qgetenv(Drivers) != "/nowhere.json") return runApart(Drivers, "/nowhere.json");
    MapView view;
    QSignalSpy failed(&view, &MapView::failed);
    view.resize(480, 300);
    view.setMap(twoScans());
    view.show();
    ASSERT_TRUE(waitFor([&] { return failed.count() > 0; }));
    EXPECT_FALSE(failed.front().front().toString().isEmpty());
    const QImage message = view.grab().toImage();
    EXPECT_GT(countPixels(message, 0xFFE6E9EF, 60), 100) << "no text on the view";
    EXPECT_TRUE(view.picture().isNull());
}

}  // namespace
}  // namespace leitstand::test
