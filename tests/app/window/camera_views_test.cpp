#include "app/window/panes/camera/camera_views.h"

#include <gtest/gtest.h>

#include "app/window/panes/camera/picture_looks.h"
#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

const SteadyTime Begin = SteadyTime(100s);

RobotDescription robotWith(const std::string& name, const std::vector<std::string>& cameras, bool infrared) {
    RobotDescription robot;
    robot.name = name;
    if (infrared) {
        StreamDescription heat;
        heat.role = StreamRole::Thermal;
        heat.sensor = "ir";
        robot.streams.push_back(heat);
    }
    for (const std::string& camera : cameras) {
        StreamDescription stream;
        stream.role = StreamRole::Picture;
        stream.sensor = camera;
        robot.streams.push_back(stream);
    }
    return robot;
}

ShownPicturePtr picture(const std::string& robot, const std::string& sensor, std::uint64_t sequence,
                        std::uint64_t fingerprint) {
    auto shown = std::make_shared<ShownPicture>();
    shown->robot = robot;
    shown->sensor = sensor;
    shown->sequence = sequence;
    shown->fingerprint = fingerprint;
    return shown;
}

TEST(CameraViews, ShowTheFirstCameraLargeAndInfraredSmall) {
    const RobotDescription kurt = robotWith("kurt3d", {"left", "right"}, true);
    CameraViews views;
    EXPECT_EQ(views.stream(CameraPlace::Large), nullptr);
    views.next();
    views.swap();
    views.select(&kurt);
    EXPECT_EQ(views.sensor(CameraPlace::Large), "left");
    EXPECT_EQ(views.sensor(CameraPlace::Small), "ir");
    for (const char* next : {"right", "ir", "right"}) {
        views.next();
        EXPECT_EQ(views.sensor(CameraPlace::Small), next) << "never the large one";
    }
    views.swap();
    EXPECT_EQ(views.sensor(CameraPlace::Large), "right");
    views.next();
    EXPECT_EQ(views.sensor(CameraPlace::Small), "ir");
}

TEST(CameraViews, EachRobotKeepsItsOwn) {
    const RobotDescription kurt = robotWith("kurt3d", {"left", "right"}, true);
    const RobotDescription crawler = robotWith("crawler", {"omni"}, false),
                           blind = robotWith("blind", {}, false);
    CameraViews views;
    views.select(&kurt);
    views.next();
    views.select(&crawler);
    EXPECT_EQ(views.sensor(CameraPlace::Large), "omni");
    EXPECT_EQ(views.stream(CameraPlace::Small), nullptr);
    views.next();
    views.swap();
    EXPECT_EQ(views.sensor(CameraPlace::Large), "omni") << "nothing to change places with";
    views.select(&blind);
    EXPECT_EQ(views.stream(CameraPlace::Large), nullptr);
    EXPECT_EQ(views.newest(CameraPlace::Large), nullptr);
    views.select(&kurt);
    EXPECT_EQ(views.sensor(CameraPlace::Small), "right");
}

TEST(CameraViews, APictureSeenAnewIsNoNewPicture) {
    const RobotDescription kurt = robotWith("kurt3d", {"left"}, false);
    CameraViews views;
    views.select(&kurt);
    EXPECT_EQ(freshnessOf(views.age(CameraPlace::Large, Begin)), Freshness::Never);
    views.took(picture("kurt3d", "left", 7, 1), Begin);
    views.took(picture("kurt3d", "left", 7, 1), Begin + 1s);  // with more contrast
    EXPECT_NEAR(views.age(CameraPlace::Large, Begin + 2s).arrival, 2.0, 1e-9);
    views.took(picture("kurt3d", "left", 8, 1), Begin + 2s);
    EXPECT_NEAR(views.age(CameraPlace::Large, Begin + 2s).arrival, 0.0, 1e-9);
    EXPECT_NEAR(views.age(CameraPlace::Large, Begin + 2s).content, 2.0, 1e-9) << "the same picture again";
}

TEST(PictureLooks, ContrastGoesRoundAndColoursStayUnlessTheyFollow) {
    PictureLooks looks;
    EXPECT_EQ(looks.look().contrast, ContrastHelp::Off);
    EXPECT_TRUE(looks.look().unwrapped);
    for (const auto help : {ContrastHelp::Gentle, ContrastHelp::Strong, ContrastHelp::Off}) {
        looks.nextContrast();
        EXPECT_EQ(looks.look().contrast, help);
    }
    const ThermalPicture cool{2, 1, {18.0F, 22.0F}}, warm{2, 1, {20.0F, 26.0F}}, hot{2, 1, {60.0F, 90.0F}};
    EXPECT_EQ(looks.rangeFor("k", "ir", cool), ThermalRange{});
    looks.setAutoRange(true);
    EXPECT_EQ(looks.rangeFor("k", "ir", cool), (ThermalRange{18.0F, 22.0F}));
    const ThermalRange then = looks.rangeFor("k", "ir", warm);
    EXPECT_GT(then.hottest, 22.0F);
    EXPECT_LT(then.hottest, 26.0F) << "not at once: it would flicker";
    EXPECT_EQ(looks.rangeFor("k", "ir", hot).hottest, 90.0F);
    EXPECT_EQ(looks.rangeFor("c", "ir", warm).hottest, 26.0F) << "each camera its own";
    looks.setAutoRange(false);
    EXPECT_EQ(looks.rangeFor("k", "ir", hot), ThermalRange{});
}

}  // namespace
}  // namespace leitstand::test
