#include "robots/simulation/sensors/camera/camera.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/event/stream_role.h"
#include "core/perception/omni/panorama.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "robots/simulation/sensors/pan_tilt.h"
#include "robots/simulation/sensors/sensor_place.h"
#include "tests/simulation/sensors/room.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

/// Where two white fields of a chessboard touch, on a dark wall.
struct Mark {
    Eigen::Vector3d at;     ///< arena's frame
    Eigen::Vector3d along;  ///< of the wall, level
};

Eigen::Vector3d lowest(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.cwiseMin(b);
}

void addMark(RoomBuilder& room, int white, const Mark& mark) {
    const Eigen::Vector3d thick = mark.along.cross(Eigen::Vector3d::UnitZ()) * 0.001;
    const double size = 0.16;
    for (const double side : {1.0, -1.0}) {
        const Eigen::Vector3d a = mark.at - thick;
        const Eigen::Vector3d b = mark.at + thick + side * size * (mark.along + Eigen::Vector3d::UnitZ());
        room.box(white, lowest(a, b), a.cwiseMax(b));
    }
}

cv::Mat greyOf(const PictureSample& sample) {
    const auto picture = decodePicture(sample);
    EXPECT_TRUE(picture) << picture.error().text;
    if (!picture) return {};
    cv::Mat rgb(picture->height, picture->width, CV_8UC3, const_cast<std::byte*>(picture->bytes.data()));
    cv::Mat grey;
    cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
    return grey;
}

/// Distance between where a mark is seen and where it should be [px].
double missOf(const cv::Mat& grey, const Eigen::Vector2d& expected) {
    std::vector<cv::Point2f> corner = {{float(expected.x()) + 1.5F, float(expected.y()) - 1.2F}};
    cv::cornerSubPix(grey, corner, {4, 4}, {-1, -1},
                     {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 50, 0.001});
    return (Eigen::Vector2d(double{corner[0].x}, double{corner[0].y}) - expected).norm();
}

struct Stage {
    RoomBuilder room;
    std::vector<Mark> marks;

    Stage() {
        const int dark = room.surface(Material::Rubber);
        room.setColour(dark, 0.25F, 0.25F, 0.25F);
        room.box(dark, {-3, -3, -0.1}, {3, 3, 0});
        room.box(dark, {-2.1, -2, 0}, {-2, 2, 1.5});
        room.box(dark, {2, -2, 0}, {2.1, 2, 1.5});
        room.box(dark, {-2, -2.1, 0}, {2, -2, 1.5});
        room.box(dark, {-2, 2, 0}, {2, 2.1, 1.5});
        const int white = room.surface(Material::Paper);
        room.setColour(white, 0.9F, 0.9F, 0.9F);
        for (const double along : {-1.2, -0.6, 0.0, 0.6, 1.2}) {
            marks.push_back({{2, along, 0.4}, Eigen::Vector3d::UnitY()});
            marks.push_back({{-2, along, 0.4}, -Eigen::Vector3d::UnitY()});
            marks.push_back({{along, 2, 0.4}, -Eigen::Vector3d::UnitX()});
            marks.push_back({{along, -2, 0.4}, Eigen::Vector3d::UnitX()});
        }
        for (const Mark& mark : marks) addMark(room, white, mark);
    }
};

/// Pixel of @p point (camera's frame) by the calibration alone that was published: plumb_bob as OpenCV has
/// it, or mei (Mei & Rives 2007) with D = k1 k2 p1 p2 xi.
Eigen::Vector2d byCalibration(const CameraInfoSample& info, const Eigen::Vector3d& point) {
    const bool mei = info.distortionModel == "mei";
    const auto& d = info.distortion;
    const Eigen::Vector3d p =
        mei ? Eigen::Vector3d(point.normalized() + d.at(4) * Eigen::Vector3d::UnitZ()) : point;
    const double x = p.x() / p.z(), y = p.y() / p.z(), r2 = x * x + y * y;
    const double k3 = mei ? 0.0 : d.at(4), radial = 1 + d[0] * r2 + d[1] * r2 * r2 + k3 * r2 * r2 * r2;
    const auto& k = info.intrinsics;  // row by row
    return {k[0] * (x * radial + 2 * d[2] * x * y + d[3] * (r2 + 2 * x * x)) + k[2],
            k[4] * (y * radial + d[2] * (r2 + 2 * y * y) + 2 * d[3] * x * y) + k[5]};
}

/// How many marks were found, and the worst miss. @p model tells what is in the picture, @p info where.
std::pair<int, double> reproject(const Stage& stage, const CameraModel& model, const CameraInfoSample& info,
                                 const Pose& cameraInArena, const PictureSample& sample) {
    const cv::Mat grey = greyOf(sample);
    EXPECT_EQ(info.header.stamp, sample.header.stamp);
    EXPECT_EQ(info.width, grey.cols);
    EXPECT_EQ(info.height, grey.rows);
    int found = 0;
    double worst = 0.0;
    for (const Mark& mark : stage.marks) {
        auto pixel = model.project(cameraInArena.inverse() * mark.at);
        if (pixel) pixel = byCalibration(info, cameraInArena.inverse() * mark.at);
        const double margin = model.mirror ? 5 : 12;
        if (!pixel || pixel->x() < margin || pixel->y() < margin || pixel->x() > model.width - margin ||
            pixel->y() > model.height - margin) {
            continue;
        }
        const double miss = missOf(grey, *pixel);
        EXPECT_LT(miss, 1.0) << "mark at " << mark.at.transpose() << ", pixel " << pixel->transpose();
        worst = std::max(worst, miss);
        ++found;
    }
    return {found, worst};
}

TEST(Camera, ShowsKnownCornersWhereTheyAreWhileItTurnsAndDrives) {
    Stage stage;
    const auto world = stage.room.world();
    const int robot = addBareRobot(*world, -0.5, 0.2, 0.3);
    PanTilt unit({}, world->now());
    const Pose onUnit = opticalAt(0.03, 0.0, 0.0);
    CameraSettings settings;
    settings.model = pinholeCamera();
    settings.quality = 95;
    settings.sensor = "left";
    settings.frame = "kurt3d/left";
    settings.cameraInBase = [&](Time time) {
        Pose axes = Pose::Identity();
        axes.translation() << 0.16, 0.08, 0.33;
        return Pose(axes * unit.platform(time) * onUnit);
    };
    Camera camera(settings, std::make_shared<SharedLight>(), Noise(1, "left"), world->now());
    world->setMotors(robot, 0.3, 0.6);
    unit.setTarget(degrees(-95), degrees(10));
    std::vector<HardwareSample> samples;
    int found = 0, pictures = 0;
    double worst = 0.0;
    for (int step = 0; step < 100; ++step) {
        world->advance(20ms);
        unit.advance(world->now());
        samples.clear();
        camera.run(*world, robot, samples);
        for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
            const auto& picture = samples[i].sample.get<PictureSample>();
            const auto& info = samples[i + 1].sample.get<CameraInfoSample>();
            EXPECT_EQ(info.distortionModel, "plumb_bob");
            const Time stamp = picture.header.stamp;
            const Pose place = world->baseInArena(robot, stamp) * settings.cameraInBase(stamp);
            const auto [marks, miss] = reproject(stage, settings.model, info, place, picture);
            found += marks;
            worst = std::max(worst, miss);
            ++pictures;
        }
    }
    EXPECT_EQ(pictures, 21);
    EXPECT_GT(found, 30);
    RecordProperty("worst_px", std::to_string(worst));
    std::printf("%d corners in %d pictures, at worst %.2f px off\n", found, pictures, worst);
}

/// A finer picture of the same mirror, in which marks are found to a fraction of a pixel.
CameraModel fineMirror() {
    CameraModel fine = omnidirectionalCamera();
    fine.width = fine.height = 960;
    fine.fx = fine.fy = 330.0;
    fine.cx = 480.9;
    fine.cy = 476.7;
    return fine;
}

TEST(Camera, BelowTheMirrorShowsKnownCornersWhereTheyAre) {
    for (const CameraModel& model : {fineMirror(), omnidirectionalCamera()}) {
        Stage stage;
        const auto world = stage.room.world();
        const int robot = addBareRobot(*world, 0.3, -0.2, 0.7);
        CameraSettings settings;
        settings.model = model;
        settings.quality = 95;
        settings.sensor = "omni";
        settings.cameraInBase = [](Time) {
            Pose pose = Pose::Identity();
            pose.linear() = mirrorAxes();
            pose.translation().z() = 0.34;
            return pose;
        };
        Camera camera(settings, std::make_shared<SharedLight>(), Noise(1, "omni"), world->now());
        std::vector<HardwareSample> samples;
        camera.run(*world, robot, samples);
        ASSERT_EQ(samples.size(), 2U);
        const auto& info = samples[1].sample.get<CameraInfoSample>();
        EXPECT_EQ(info.distortionModel, "mei");
        const Pose place = world->state(robot).baseInArena * settings.cameraInBase(world->now());
        const auto [found, worst] =
            reproject(stage, settings.model, info, place, samples[0].sample.get<PictureSample>());
        EXPECT_EQ(found, 20) << "all around";
        std::printf("%d corners in %d x %d, at worst %.2f px off\n", found, model.width, model.height, worst);
    }
}

TEST(Camera, BelowTheMirrorIsUnwrappedTrueToDirections) {
    Stage stage;
    const auto world = stage.room.world();
    const int robot = addBareRobot(*world, 0.3, -0.2, 0.7);
    Pose mount = Pose::Identity();
    mount.linear() = mirrorAxes();
    mount.translation().z() = 0.34;
    CameraSettings settings;
    settings.model = fineMirror();
    settings.quality = 95;
    settings.sensor = "omni";
    settings.cameraInBase = [mount](Time) { return mount; };
    Camera camera(settings, std::make_shared<SharedLight>(), Noise(1, "omni"), world->now());
    std::vector<HardwareSample> samples;
    camera.run(*world, robot, samples);
    ASSERT_EQ(samples.size(), 2U);
    const auto picture = decodePicture(samples[0].sample.get<PictureSample>());
    ASSERT_TRUE(picture);
    const auto panorama =
        Panorama::of(samples[1].sample.get<CameraInfoSample>(), picture->width, picture->height, mount);
    ASSERT_TRUE(panorama);
    Picture unwrapped = panorama->unwrapped(*picture);
    const cv::Mat rgb(unwrapped.height, unwrapped.width, CV_8UC3, unwrapped.bytes.data());
    cv::Mat grey;
    cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
    const Pose baseInArena = world->state(robot).baseInArena;
    double worst = 0.0;
    int found = 0;
    for (const Mark& mark : stage.marks) {
        // as the robot would point at it from its mirror
        const Eigen::Vector3d seen = baseInArena.inverse() * mark.at - mount.translation();
        const Eigen::Vector2d expected(
            panorama->shape().columnOf(std::atan2(seen.y(), seen.x())) - 0.5,
            panorama->shape().rowOf(std::atan2(seen.z(), seen.head<2>().norm())) - 0.5);
        if (expected.x() < 8 || expected.x() > unwrapped.width - 8) continue;
        const double miss = missOf(grey, expected);
        EXPECT_LT(miss, 1.0) << "mark at " << mark.at.transpose();
        worst = std::max(worst, miss);
        ++found;
    }
    EXPECT_GE(found, 18);
    std::printf("%d corners in the panorama, at worst %.2f px off\n", found, worst);
}

TEST(Camera, AdaptsToLightAndDark) {
    for (const double light : {1.0, 0.15}) {
        Stage stage;
        stage.room.arena().light = light;
        const auto world = stage.room.world();
        const int robot = addBareRobot(*world);
        CameraSettings settings;
        settings.model = pinholeCamera();
        settings.cameraInBase = [](Time) { return opticalAt(0.0, 0.0, 0.4); };
        Camera camera(settings, std::make_shared<SharedLight>(), Noise(1, "left"), world->now());
        std::vector<HardwareSample> samples;
        camera.run(*world, robot, samples);
        const cv::Mat grey = greyOf(samples.at(0).sample.get<PictureSample>());
        const double mean = cv::mean(grey)[0];
        EXPECT_GT(mean, light > 0.5 ? 70 : 25);
        EXPECT_LT(mean, 180);
    }
}

TEST(Camera, ShadesWhatALampDoesNotReach) {
    RoomBuilder room;
    room.walls(3, 3, 2);
    room.box(room.surface(Material::Plaster), {-0.05, -1.0, 0.0}, {0.05, 1.0, 1.8});
    room.arena().light = 0.0;
    Element lamp;
    lamp.kind = ElementKind::Lamp;
    lamp.pose.translation() << 1.5, 0.0, 1.0;
    lamp.size = {0.1, 0.1, 0.1};
    room.arena().elements.push_back(lamp);
    const auto world = room.world();
    const LightField light(world->scene());
    const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
    const float before = light.at({1.0F, 0.0F, 0.0F}, up), behind = light.at({-0.8F, 0.0F, 0.0F}, up);
    EXPECT_GT(before, 0.2F);
    EXPECT_LT(behind, 0.05F * before) << "no light through walls";
    EXPECT_GT(light.at({2.2F, 2.0F, 0.0F}, up), 0.02F);
    EXPECT_LT(light.at({2.2F, 2.0F, 0.0F}, up), before) << "less far away";
    EXPECT_EQ(light.direct(up), 0.0F);
}

TEST(Camera, HonoursWhatIsAskedOfItsStream) {
    Stage stage;
    const auto world = stage.room.world();
    const int robot = addBareRobot(*world);
    CameraSettings settings;
    settings.model = pinholeCamera();
    settings.sensor = "left";
    settings.cameraInBase = [](Time) { return opticalAt(0.0, 0.0, 0.4); };
    Camera camera(settings, std::make_shared<SharedLight>(), Noise(1, "left"), world->now());
    std::vector<HardwareSample> samples;
    const auto run = [&](std::chrono::nanoseconds time) {
        samples.clear();
        for (const Time end = world->now() + time; world->now() < end;) {
            world->advance(20ms);
            camera.run(*world, robot, samples);
        }
        std::size_t bytes = 0;
        int pictures = 0, width = 0;
        for (const HardwareSample& sample : samples) {
            if (const auto* picture = sample.sample.as<PictureSample>()) {
                bytes += picture->content.bytes.size();
                ++pictures;
            } else {
                width = sample.sample.get<CameraInfoSample>().width;
            }
        }
        return std::tuple(pictures, width, pictures == 0 ? 0 : bytes / std::size_t(pictures));
    };
    const auto [pictures, width, bytes] = run(1s);
    EXPECT_NEAR(pictures, 10, 1);
    EXPECT_EQ(width, 320);
    EXPECT_FALSE(camera.configure(StreamRole::Picture, "right", {}));
    EXPECT_TRUE(camera.configure(StreamRole::Picture, "left", {true, 5.0, 30, 160}));
    const auto [fewer, narrower, smaller] = run(2s);
    EXPECT_NEAR(fewer, 10, 1);
    EXPECT_EQ(narrower, 160) << "the calibration goes with the picture";
    EXPECT_LT(smaller, bytes / 2);
    EXPECT_TRUE(camera.configure(StreamRole::Picture, "left", {.enabled = false}));
    EXPECT_EQ(std::get<0>(run(1s)), 0);
    EXPECT_TRUE(camera.configure(StreamRole::Picture, "left", {.rate = 1000.0}));
    EXPECT_NEAR(std::get<0>(run(1s)), 15, 1) << "no more than it can";
}

}  // namespace
}  // namespace leitstand::simulation::test
