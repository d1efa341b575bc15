// Models of robots: where their links are, what they look like, how much room they take.
#include "core/robot/model/robot_model.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/footprint.h"
#include "core/robot/model/model_body.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double Quarter = std::numbers::pi / 2;

ModelJoint joint(const std::string& name, ModelJointType type, std::size_t parent, std::size_t child,
                 const Eigen::Vector3d& at, const Eigen::Vector3d& axis) {
    ModelJoint made;
    made.name = name;
    made.type = type;
    made.parent = parent;
    made.child = child;
    made.jointInParent.translation() = at;
    made.axis = axis;
    return made;
}

/// A base, an arm that is raised about -y, and a hand that slides along it.
RobotModel arm() {
    RobotModel model;
    for (const char* name : {"base_link", "arm", "hand"}) model.links.push_back({name, {}, {}});
    model.joints = {joint("shoulder", ModelJointType::Revolute, 0, 1, {0, 0, 1}, -Eigen::Vector3d::UnitY()),
                    joint("slide", ModelJointType::Prismatic, 1, 2, {0.5, 0, 0}, Eigen::Vector3d::UnitX())};
    return model;
}

TEST(RobotModel, JointsMoveTheLinksBehindThem) {
    const RobotModel model = arm();
    const auto poses = linksInBase(
        model, 0, [](const std::string& name) { return std::optional(name == "shoulder" ? Quarter : 0.25); });
    EXPECT_TRUE(poses[0].isApprox(Pose::Identity()));
    EXPECT_TRUE(poses[2].translation().isApprox(Eigen::Vector3d(0, 0, 1.75), 1e-12));
    EXPECT_TRUE((poses[2] * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(0, 0, 2.75), 1e-12));
}

TEST(RobotModel, PosesCountFromTheBaseWhereverItIsInTheTree) {
    const RobotModel model = arm();
    const auto none = [](const std::string&) { return std::optional<double>(); };
    const auto poses = linksInBase(model, 1, none);
    EXPECT_TRUE(poses[0].translation().isApprox(Eigen::Vector3d(0, 0, -1)));
    EXPECT_TRUE(poses[1].isApprox(Pose::Identity()));
}

TEST(RobotModel, AJointThatNobodyTellsIsAtRestWithinItsLimits) {
    RobotModel model = arm();
    model.joints[1].lower = 0.1;
    model.joints[1].upper = 0.4;
    const auto none = [](const std::string&) { return std::optional<double>(); };
    EXPECT_TRUE(linksInBase(model, 0, none)[2].translation().isApprox(Eigen::Vector3d(0.6, 0, 1)));
}

TEST(RobotModel, AJointThatMimicsAnotherFollowsIt) {
    RobotModel model = arm();
    model.joints[1].mimics = MimickedJoint{"shoulder", 0.5, 0.1};
    const auto poses = linksInBase(model, 0, [](const std::string& name) {
        return name == "shoulder" ? std::optional(0.4) : std::nullopt;
    });
    EXPECT_NEAR((poses[2].translation() - Eigen::Vector3d(0, 0, 1)).norm(), 0.5 + 0.5 * 0.4 + 0.1, 1e-12);
}

TEST(RobotModel, PositionsThatMakeNoSenseAreUnknown) {
    RobotModel model = arm();
    for (const double wrong : {std::nan(""), 1e300, -1e300}) {
        const auto poses = linksInBase(model, 0, [&](const std::string&) { return std::optional(wrong); });
        EXPECT_TRUE(poses[2].translation().isApprox(Eigen::Vector3d(0.5, 0, 1))) << wrong;
    }
    model.joints[1].mimics = MimickedJoint{"shoulder", 1e6, 0.0};
    const auto poses = linksInBase(model, 0, [](const std::string& name) {
        return name == "shoulder" ? std::optional(1.0) : std::nullopt;
    });
    EXPECT_NEAR((poses[2].translation() - Eigen::Vector3d(0, 0, 1)).norm(), 0.5, 1e-9);
}

TEST(RobotModel, LinksAreFoundWithAndWithoutTheRobotsPrefix) {
    EXPECT_EQ(arm().linkAt("rover/arm"), 1U);
    EXPECT_EQ(arm().linkAt("leg"), std::nullopt);
}

/// Six times the volume within a closed surface whose sides face outwards [m^3].
double volumeOf(const TriangleMesh& mesh) {
    double volume = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        volume += mesh.vertices[a].cast<double>().dot(
                      mesh.vertices[b].cast<double>().cross(mesh.vertices[c].cast<double>())) /
                  6.0;
    return volume;
}

TEST(SurfaceOf, ShapesAreClosedAndFaceOutwards) {
    const PartColour red(1, 0, 0);
    EXPECT_NEAR(volumeOf(surfaceOf(BoxShape{{0.2, 0.3, 0.4}}, red)), 0.2 * 0.3 * 0.4, 1e-6);
    EXPECT_NEAR(volumeOf(surfaceOf(CylinderShape{0.5, 2.0}, red)), std::numbers::pi * 0.25 * 2.0, 0.03);
    EXPECT_NEAR(volumeOf(surfaceOf(SphereShape{0.5}, red)), std::numbers::pi / 6.0, 0.03);
    EXPECT_TRUE(surfaceOf(MeshShape{"package://a/b.stl"}, red).triangles.empty());
}

TEST(Reduced, KeepsTheFormWithFewTriangles) {
    TriangleMesh ball = surfaceOf(SphereShape{0.5}, PartColour(1, 0, 0));
    const std::size_t before = ball.triangles.size();
    const TriangleMesh same = reduced(ball, before);
    EXPECT_EQ(same.triangles.size(), before);
    const TriangleMesh fewer = reduced(ball, 150);
    EXPECT_LE(fewer.triangles.size(), 150U);
    EXPECT_EQ(fewer.triangles.size(), fewer.colours.size());
    EXPECT_NEAR(volumeOf(fewer), std::numbers::pi / 6.0, 0.2);
    // All vertices at one place, or none.
    TriangleMesh point;
    point.vertices = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    for (int i = 0; i < 9; ++i) point.triangles.push_back({0, 1, 2}), point.colours.emplace_back(1, 0, 0);
    EXPECT_TRUE(reduced(point, 3).triangles.empty());
}

LinkPart part(PartShape shape, double x = 0.0) {
    LinkPart made;
    made.partInLink.translation().x() = x;
    made.shape = std::move(shape);
    return made;
}

Result<TriangleMesh> noMesh(const std::string& uri) {
    return Error{uri + ": not here"};
}

TEST(BodyOf, ALinkWhoseMeshIsMissingIsDrawnWithItsSimpleShapes) {
    RobotModel model = arm();
    model.links[0].visuals = {part(MeshShape{"package://a/b.dae"}), part(MeshShape{"package://a/b.dae"})};
    model.links[0].collisions = {part(BoxShape{{1, 1, 1}}), part(MeshShape{"package://a/c.stl"})};
    model.links[1].visuals = {part(MeshShape{"package://a/b.dae"})};
    model.links[2].visuals = {part(SphereShape{0.1})};
    const ModelBody body = bodyOf(model, "base_link", noMesh);
    ASSERT_EQ(body.parts.size(), 2U) << "of the arm there is nothing to draw";
    EXPECT_EQ(body.parts[0].link, 0U);
    EXPECT_EQ(body.parts[0].surface.triangles.size(), 12U) << "the box";
    EXPECT_EQ(body.parts[1].link, 2U);
    EXPECT_THAT(body.missing, ElementsAre("package://a/b.dae: not here")) << "told once";
}

TEST(BodyOf, MeshesAreScaledAndStayOutwardsWhenMirrored) {
    RobotModel model = arm();
    MeshShape mirrored{"m", {1.0, -2.0, 1.0}};
    model.links[0].visuals = {part(mirrored, 3.0)};
    const ModelBody body = bodyOf(model, "base_link", [](const std::string&) {
        return Result<TriangleMesh>(surfaceOf(BoxShape{{1, 1, 1}}, PartColour(0, 1, 0)));
    });
    ASSERT_EQ(body.parts.size(), 1U);
    EXPECT_NEAR(volumeOf(body.parts[0].surface), 2.0, 1e-5);
    for (const auto& vertex : body.parts[0].surface.vertices) EXPECT_GE(vertex.x(), 2.49F);
}

TEST(BodyOf, ManyTrianglesBecomeFew) {
    RobotModel model;
    for (int i = 0; i < 300; ++i) {
        model.links.push_back({"l" + std::to_string(i), {}, {}});
        model.links.back().visuals = {part(SphereShape{0.5}, i)};
        if (i > 0)
            model.joints.push_back(joint("j" + std::to_string(i), ModelJointType::Fixed, 0,
                                         static_cast<std::size_t>(i), {0, 0, 0}, Eigen::Vector3d::UnitX()));
    }
    const ModelBody body = bodyOf(model, "no such link", noMesh);
    EXPECT_EQ(body.base, model.root);
    std::size_t triangles = 0;
    for (const BodyPart& one : body.parts) triangles += one.surface.triangles.size();
    EXPECT_EQ(body.parts.size(), 300U);
    EXPECT_LE(triangles, ModelBody::MostTriangles);
}

TEST(BodyOf, OneLinkWithManyPartsIsBoundedWhileItIsMade) {
    RobotModel model;
    model.links = {{"base_link", {}, {}}};
    for (int i = 0; i < 5'000; ++i) model.links[0].visuals.push_back(part(SphereShape{0.5}, 0.001 * i));
    const ModelBody body = bodyOf(model, "base_link", noMesh);
    ASSERT_EQ(body.parts.size(), 1U);
    EXPECT_LE(body.parts[0].surface.triangles.size(), ModelBody::MostTriangles);
}

TEST(BodyOf, SmallPartsKeepTheirFormBesideALargeOne) {
    RobotModel model = arm();
    TriangleMesh huge;
    for (std::uint32_t i = 0; i < 100'000; ++i) {
        const auto x = static_cast<float>(i % 1'000) * 1e-3F, y = static_cast<float>(i / 1'000) * 1e-2F;
        huge.vertices.insert(huge.vertices.end(), {{x, y, 0}, {x + 1e-3F, y, 0}, {x, y + 1e-2F, 0}});
        huge.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        huge.colours.emplace_back(1, 1, 1);
    }
    model.links[0].visuals = {part(MeshShape{"huge"})};
    model.links[1].visuals = {part(BoxShape{{0.1, 0.1, 0.1}})};
    const ModelBody body =
        bodyOf(model, "base_link", [&](const std::string&) { return Result<TriangleMesh>(huge); });
    ASSERT_EQ(body.parts.size(), 2U);
    EXPECT_EQ(body.parts[1].surface.triangles.size(), 12U);
}

TEST(ExtentOf, OfWhatIsNoRobotIsRefused) {
    RobotModel model = arm();
    model.links[0].visuals = {part(BoxShape{{30, 1, 1}})};
    EXPECT_THAT(extentOf(bodyOf(model, "base_link", noMesh)).error().text, HasSubstr("farther than 10 m"));
    model.links[0].visuals = {part(BoxShape{{1, 1, 0.001}})};
    EXPECT_THAT(extentOf(bodyOf(model, "base_link", noMesh)).error().text, HasSubstr("flatter"));
    model.links[0].visuals = {part(BoxShape{{1, 1, 1}})};
    model.links[1].visuals = {part(MeshShape{"package://a/b.dae"})};
    EXPECT_THAT(extentOf(bodyOf(model, "base_link", noMesh)).error().text, HasSubstr("not here"));
}

TEST(ExtentOf, IsTheOutlineFromAboveAndTheHeight) {
    RobotModel model = arm();
    model.links[0].visuals = {part(BoxShape{{0.8, 0.4, 0.2}})};
    model.links[1].visuals = {part(BoxShape{{0.1, 0.1, 0.1}})};
    const auto extent = extentOf(bodyOf(model, "base_link", noMesh));
    ASSERT_TRUE(extent) << extent.error().text;
    EXPECT_NEAR(signedArea(extent->footprint), 0.8 * 0.4, 1e-6);
    EXPECT_EQ(footprintProblem(extent->footprint), "");
    EXPECT_NEAR(extent->height, 1.05 + 0.1, 1e-6);
}

TEST(ExtentOf, ARoundRobotGetsFewCornersAroundAllOfIt) {
    RobotModel model = arm();
    model.links[0].visuals = {part(CylinderShape{0.2, 0.1}), part(CylinderShape{0.19, 0.3})};
    const auto extent = extentOf(bodyOf(model, "base_link", noMesh));
    ASSERT_TRUE(extent) << extent.error().text;
    EXPECT_LE(extent->footprint.size(), 16U);
    const double circle = std::numbers::pi * 0.04;
    EXPECT_GE(signedArea(extent->footprint), 0.98 * circle) << "never smaller than the robot";
    EXPECT_LE(signedArea(extent->footprint), 1.05 * circle);
}

TEST(ExtentOf, AModelWithoutSurfacesHasNone) {
    const auto extent = extentOf(bodyOf(arm(), "base_link", noMesh));
    ASSERT_FALSE(extent);
    EXPECT_THAT(extent.error().text, HasSubstr("no surface"));
}

}  // namespace
}  // namespace leitstand::test
