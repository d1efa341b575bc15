// A robot as its model, over the map.
#include "widgets/map_view/robots/body_overlay.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <QImage>
#include <QPainter>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/models/map/robots/robot_mark.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

const PartColour Red(1, 0, 0), Green(0, 1, 0);

LinkPart box(const Eigen::Vector3d& size, const Eigen::Vector3d& at, const PartColour& colour) {
    LinkPart part;
    part.shape = BoxShape{size};
    part.partInLink.translation() = at;
    part.colour = colour;
    return part;
}

RobotMark markOf(const std::vector<LinkPart>& parts) {
    RobotModel model;
    model.links = {{"base_link", parts, {}}};
    RobotMark mark;
    mark.footprint = {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}};
    mark.body = std::make_shared<const ModelBody>(bodyOf(
        model, "base_link", [](const std::string& uri) -> Result<TriangleMesh> { return Error{uri}; }));
    mark.linksInBase = {Pose::Identity()};
    return mark;
}

/// From behind and above, @p distance away [m].
MapCamera cameraAt(double distance) {
    MapCamera camera;
    camera.distance = distance;
    return camera;
}

struct Painted {
    bool painted = false;
    QImage picture;
    std::chrono::duration<double, std::milli> took{};
};

Painted paint(const RobotMark& mark, const MapCamera& camera, const BodyLook& look = {},
              QSize size = {600, 400}) {
    Painted result;
    result.picture = QImage(size, QImage::Format_ARGB32_Premultiplied);
    result.picture.fill(Qt::black);
    QPainter painter(&result.picture);
    const OverlayStyle style{mapColours(Theme::Dark), &coloursOf(Theme::Dark), QFont(), QLocale::c()};
    const MapProjection projection(camera, size);
    const auto began = std::chrono::steady_clock::now();
    result.painted = paintModel(painter, projection, mark, look, style);
    result.took = std::chrono::steady_clock::now() - began;
    return result;
}

/// Pixels of @p picture in which @p one of red, green and blue is more than twice the others.
int count(const QImage& picture, int (*one)(QRgb), int (*other)(QRgb), int (*third)(QRgb)) {
    int found = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            found +=
                one(pixel) > 2 * other(pixel) && one(pixel) > 2 * third(pixel) && one(pixel) > 60 ? 1 : 0;
        }
    }
    return found;
}
int reds(const QImage& picture) {
    return count(picture, &qRed, &qGreen, &qBlue);
}
int greens(const QImage& picture) {
    return count(picture, &qGreen, &qRed, &qBlue);
}

TEST(BodyOverlay, NearerPartsHideFartherOnesWhateverTheirOrder) {
    const LinkPart front = box({0.1, 1.0, 1.0}, {-0.5, 0, 0.5}, Red),
                   back = box({0.1, 0.8, 0.8}, {0.5, 0, 0.5}, Green);
    MapCamera camera = cameraAt(4.0);
    camera.pitch = 0.0;
    for (const auto& parts : {std::vector{front, back}, std::vector{back, front}}) {
        const Painted seen = paint(markOf(parts), camera);
        ASSERT_TRUE(seen.painted);
        EXPECT_GT(reds(seen.picture), 1'000);
        EXPECT_EQ(greens(seen.picture), 0) << "behind the red one";
    }
    camera.yaw = 3.14159265;
    const Painted other = paint(markOf({front, back}), camera);
    EXPECT_GT(greens(other.picture), 1'000) << "seen from ahead";
}

TEST(BodyOverlay, AParallelViewShowsItFromAbove) {
    MapCamera camera = cameraAt(4.0);
    camera.parallel = true;
    camera.pitch = 1.5707;
    const Painted seen = paint(
        markOf({box({0.6, 0.4, 0.1}, {0, 0, 0.1}, Red), box({0.2, 0.2, 0.1}, {0, 0, 0.3}, Green)}), camera);
    ASSERT_TRUE(seen.painted);
    EXPECT_GT(greens(seen.picture), 100) << "on top";
    EXPECT_GT(reds(seen.picture), greens(seen.picture));
}

TEST(BodyOverlay, ARobotThatIsNotHeardIsGreyAndFaint) {
    const RobotMark mark = markOf({box({0.6, 0.4, 0.3}, {0, 0, 0.2}, Red)});
    EXPECT_GT(reds(paint(mark, cameraAt(3.0)).picture), 1'000);
    EXPECT_EQ(reds(paint(mark, cameraAt(3.0), {0.45, true}).picture), 0);
}

TEST(BodyOverlay, WhatCannotBePaintedIsLeftToTheSymbol) {
    RobotMark mark = markOf({box({0.6, 0.4, 0.3}, {0, 0, 0.2}, Red)});
    EXPECT_FALSE(paint(mark, cameraAt(0.1)).painted) << "the eye is in it";
    mark.linksInBase[0].translation().x() = std::nan("");
    EXPECT_FALSE(paint(mark, cameraAt(3.0)).painted) << "nobody knows where it is";
    mark.linksInBase.clear();
    EXPECT_FALSE(paint(mark, cameraAt(3.0)).painted);
    mark.body.reset();
    EXPECT_FALSE(paint(mark, cameraAt(3.0)).painted);
}

TEST(BodyOverlay, ABodyOfLargeSidesIsGivenUpInTime) {
    std::vector<LinkPart> parts;
    for (int i = 0; i < 1'000; ++i) parts.push_back(box({8, 8, 0.01}, {0, 0, 0.002 * i}, Red));
    const Painted seen = paint(markOf(parts), cameraAt(12.0), {}, {1'920, 1'080});
    EXPECT_FALSE(seen.painted);
    EXPECT_LT(seen.took.count(), 1'000.0) << "of a machine that does nothing else: some 20 ms";
    std::printf("given up after %.1f ms\n", seen.took.count());
}

TEST(BodyOverlay, TellsWhatTheLargestBodyCosts) {
    std::vector<LinkPart> parts;
    for (int i = 0; i < 25; ++i) {
        LinkPart ball;
        ball.shape = SphereShape{0.1};
        ball.partInLink.translation() = Eigen::Vector3d(0.15 * (i % 5) - 0.3, 0.15 * (i / 5) - 0.3, 0.1);
        parts.push_back(ball);
    }
    const RobotMark mark = markOf(parts);
    std::size_t triangles = 0;
    for (const BodyPart& part : mark.body->parts) triangles += part.surface.triangles.size();
    for (const double distance : {8.0, 1.6}) {
        const Painted seen = paint(mark, cameraAt(distance), {}, {1'280, 800});
        EXPECT_TRUE(seen.painted);
        std::printf("%zu triangles from %.1f m: %.1f ms\n", triangles, distance, seen.took.count());
    }
}

}  // namespace
}  // namespace leitstand::test
