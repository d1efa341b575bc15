#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "robots/simulation/sensors/camera/infrared_camera.h"
#include "tests/simulation/sensors/room.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;
constexpr double Zero = 273.15;

InfraredSettings mounted() {
    InfraredSettings settings;
    settings.model = infraredOptics();
    settings.sensor = "ir";
    settings.frame = "kurt3d/ir";
    settings.cameraInBase = [](Time) { return opticalAt(0.2, 0.0, 0.4); };
    return settings;
}

ThermalPicture pictureOf(const HardwareSample& sample) {
    const auto picture = decodePicture(sample.sample.get<PictureSample>());
    EXPECT_TRUE(picture);
    const auto thermal = temperatures(*picture, {});
    EXPECT_TRUE(thermal);
    return *thermal;
}

struct Spot {
    double mean = 0.0, deviation = 0.0;
};

/// Of 9 x 9 pixels about where @p point (base_link) is seen.
Spot spotAt(const ThermalPicture& picture, const Eigen::Vector3d& point) {
    const InfraredSettings settings = mounted();
    const Eigen::Vector2d pixel = *settings.model.project(settings.cameraInBase({}).inverse() * point);
    double sum = 0, squares = 0;
    for (int dy = -4; dy <= 4; ++dy) {
        for (int dx = -4; dx <= 4; ++dx) {
            const auto row = std::size_t(std::lround(pixel.y()) + dy),
                       column = std::size_t(std::lround(pixel.x()) + dx);
            const double value = double{picture.celsius[row * std::size_t(picture.width) + column]};
            sum += value;
            squares += value * value;
        }
    }
    const double mean = sum / 81;
    return {mean, std::sqrt(squares / 81 - mean * mean)};
}

TEST(Infrared, MeasuresTemperaturesWithinItsNoise) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    room.box(room.surface(Material::Skin, Label::Wall, 34.0), {2, 0.1, 0.2}, {2.1, 0.5, 0.6});
    room.box(room.surface(Material::Metal, Label::Wall, 60.0), {2, -0.5, 0.2}, {2.1, -0.1, 0.6});
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    InfraredCamera camera(mounted(), Noise(1, "ir"), world->now());
    std::vector<HardwareSample> samples;
    camera.run(*world, robot, samples);
    ASSERT_EQ(samples.size(), 2U);
    EXPECT_EQ(samples[0].role, StreamRole::Thermal);
    const ThermalPicture picture = pictureOf(samples[0]);
    EXPECT_EQ(picture.width, 160);
    EXPECT_EQ(picture.height, 120);
    const auto shown = [](double emissivity, double celsius) {
        return std::pow(emissivity * std::pow(celsius + Zero, 4) + (1 - emissivity) * std::pow(20 + Zero, 4),
                        0.25) -
               Zero;
    };
    const Spot skin = spotAt(picture, {2, 0.3, 0.4}), metal = spotAt(picture, {2, -0.3, 0.4});
    EXPECT_NEAR(skin.mean, shown(0.98, 34.0), 0.04);
    EXPECT_NEAR(skin.deviation, 0.1, 0.03);
    EXPECT_NEAR(skin.mean, 34.0, 0.4) << "a victim's temperature can be read";
    EXPECT_NEAR(metal.mean, shown(0.30, 60.0), 0.04) << "metal looks colder than it is";
    EXPECT_NEAR(spotAt(picture, {4, 0.0, 0.8}).mean, 20.0, 0.04);
}

TEST(Infrared, SeesThroughFoil) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    room.box(room.surface(Material::Skin, Label::Wall, 34.0), {2, -0.4, 0.2}, {2.1, 0.4, 0.6});
    room.box(room.surface(Material::Foil), {1.5, -1.0, 0.0}, {1.501, 1.0, 1.0});
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    InfraredCamera camera(mounted(), Noise(1, "ir"), world->now());
    std::vector<HardwareSample> samples;
    camera.run(*world, robot, samples);
    const double seen = spotAt(pictureOf(samples.at(0)), {2, 0.0, 0.4}).mean;
    EXPECT_GT(seen, 29.0);
    EXPECT_LT(seen, 34.0);
}

TEST(Infrared, HoldsItsRateAndSwitches) {
    RoomBuilder room;
    room.walls(4, 3, 2);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    InfraredCamera camera(mounted(), Noise(1, "ir"), world->now());
    std::vector<HardwareSample> samples;
    const auto count = [&] {
        samples.clear();
        for (int i = 0; i < 100; ++i) {
            world->advance(20ms);
            camera.run(*world, robot, samples);
        }
        return samples.size();
    };
    EXPECT_NEAR(double(count()), 36.0, 2.0) << "9 Hz, with calibration";
    EXPECT_TRUE(camera.configure(StreamRole::Thermal, "ir", {true, 3.0, 0, 80}));
    EXPECT_NEAR(double(count()), 12.0, 2.0);
    EXPECT_EQ(pictureOf(samples[0]).width, 80);
    EXPECT_TRUE(camera.configure(StreamRole::Thermal, "ir", {.enabled = false}));
    EXPECT_TRUE(camera.configure(StreamRole::CameraInfo, "ir", {.enabled = false}));
    EXPECT_EQ(count(), 0U);
    EXPECT_FALSE(camera.configure(StreamRole::Picture, "left", {}));
}

}  // namespace
}  // namespace leitstand::simulation::test
