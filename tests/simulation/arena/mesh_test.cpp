#include <gtest/gtest.h>

#include "robots/simulation/arena/random.h"
#include "tests/simulation/arena/mesh_checks.h"

namespace leitstand::simulation {
namespace {

using namespace test;

/// One of each kind, not at the origin, turned.
Element sample(int kind) {
    Element element = elementOf(static_cast<ElementKind>(kind));
    element.pose = poseFrom({1.0, -2.0, 0.5}, 0.0, 0.0, degrees(30));
    element.text = "qr:V-07";
    element.angle = degrees(60);
    element.width = element.kind == ElementKind::Spectator ? 0.5 : element.width;
    element.seed = 5;
    if (element.victim) element.victim = VictimTraits{"V-07", Situation::Void, true, 34.0, 4000.0, false};
    Random random(1);
    if (element.kind == ElementKind::StepField) {
        for (int i = 0; i < 144; ++i) element.heights.push_back(0.1 * random.below(4));
    }
    return element;
}

Mesh stillMeshOf(const Element& element) {
    return meshOf(arenaOf(element)).still;
}

TEST(ArenaMesh, IsConsistentForEveryKind) {
    for (int kind = 0; kind < ElementKindCount; ++kind) {
        const Element element = sample(kind);
        SCOPED_TRACE(toString(element.kind));
        const ArenaMesh mesh = meshOf(arenaOf(element));
        EXPECT_EQ(faultOf(mesh.still), "");
        if (element.kind == ElementKind::Smoke) {  // nothing to meet
            EXPECT_TRUE(mesh.still.triangles.empty());
            continue;
        }
        std::size_t triangles = mesh.still.triangles.size();
        for (const MovingPart& part : mesh.moving) {
            EXPECT_EQ(faultOf(part.mesh), "");
            triangles += part.mesh.triangles.size();
            EXPECT_LT(openArea(part.mesh).norm(), 1e-3);
        }
        EXPECT_GT(triangles, 0U);
        EXPECT_LT(triangles, 12'000U);
        for (const Surface& surface : mesh.still.surfaces) EXPECT_EQ(surface.element, 0);
    }
}

TEST(ArenaMesh, SolidsAreClosedAndFaceOutwards) {
    for (int kind = 0; kind < ElementKindCount; ++kind) {
        Element element = sample(kind);
        switch (element.kind) {
            case ElementKind::Curtain:
            case ElementKind::LoosePaper:
            case ElementKind::Foil:
            case ElementKind::Sign:  // a plate and the picture before it
            case ElementKind::Spectator:
            case ElementKind::Smoke:
                continue;
            case ElementKind::Victim:
                element.victim->tag.clear();
                break;
            default:
                break;
        }
        SCOPED_TRACE(toString(element.kind));
        const Mesh mesh = stillMeshOf(element);
        EXPECT_LT(openArea(mesh).norm(), 1e-3 * areaOf(mesh));
        EXPECT_GT(volumeOf(mesh), 0.0);
    }
}

TEST(ArenaMesh, HasTheVolumesOfItsElements) {
    Element element = elementOf(ElementKind::Wall);
    element.size = {2.0, 0.1, 1.5};
    EXPECT_NEAR(volumeOf(stillMeshOf(element)), 0.3, 1e-4);
    EXPECT_EQ(stillMeshOf(element).triangles.size(), 12U);

    element = elementOf(ElementKind::Ramp);
    element.size = {2.0, 1.0, 0.5};
    EXPECT_NEAR(volumeOf(stillMeshOf(element)), 0.5, 1e-4);

    element = elementOf(ElementKind::Stairs);
    element.size = {1.2, 1.0, 0.4};
    element.riser = 0.1;  // four treads of 0.3 m
    EXPECT_NEAR(volumeOf(stillMeshOf(element)), 0.3 * (0.1 + 0.2 + 0.3 + 0.4), 1e-4);

    element = elementOf(ElementKind::Floor);
    element.size = {3.0, 2.0, 0.1};
    const Eigen::AlignedBox3d floor = boundsOf(stillMeshOf(element));
    EXPECT_NEAR(floor.max().z(), 0.0, 1e-6);
    EXPECT_NEAR(floor.min().z(), -0.1, 1e-6);

    element = elementOf(ElementKind::StepField);
    element.size = {0.2, 0.1, 0.3};
    element.heights = {0.1, 0.3};
    EXPECT_NEAR(volumeOf(stillMeshOf(element)), 0.01 * 0.4, 1e-5);
}

TEST(ArenaMesh, LabelsStructureByItsSlope) {
    Element element = elementOf(ElementKind::Wall);
    element.size = {2.0, 0.1, 1.0};
    Mesh mesh = stillMeshOf(element);
    EXPECT_NEAR(areaOf(mesh, Label::Wall), 2 * (2.0 + 0.1), 1e-4);
    EXPECT_NEAR(areaOf(mesh, Label::Floor), 0.2, 1e-4);
    EXPECT_NEAR(areaOf(mesh, Label::Ceiling), 0.2, 1e-4);

    element = elementOf(ElementKind::Ramp);  // 14 degrees: floor
    element.size = {2.0, 1.0, 0.5};
    EXPECT_NEAR(areaOf(stillMeshOf(element), Label::Floor), std::hypot(2.0, 0.5), 1e-4);

    element = elementOf(ElementKind::Ceiling);
    element.size = {2.0, 2.0, 0.03};
    element.pose = poseFrom({0, 0, 2}, 0, 0, 0);
    EXPECT_NEAR(areaOf(stillMeshOf(element), Label::Ceiling), 4.0, 1e-4);

    for (const ElementKind kind :
         {ElementKind::Table, ElementKind::Victim, ElementKind::Heater, ElementKind::Curtain}) {
        mesh = stillMeshOf(sample(static_cast<int>(kind)));
        EXPECT_NEAR(areaOf(mesh, Label::Unlabelled), areaOf(mesh), 1e-9) << toString(kind);
    }
}

TEST(ArenaMesh, StaysWithinTheElementsSize) {
    for (const ElementKind kind :
         {ElementKind::Table, ElementKind::Chair, ElementKind::Heater, ElementKind::Curtain,
          ElementKind::Foil, ElementKind::LoosePaper, ElementKind::Lamp, ElementKind::Rubble}) {
        SCOPED_TRACE(toString(kind));
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            Element element = elementOf(kind);
            element.seed = seed;
            const Eigen::AlignedBox3d box = boundsOf(stillMeshOf(element));
            EXPECT_LE(box.sizes().x(), element.size.x() + 0.01);
            EXPECT_LE(box.sizes().y(), element.size.y() + 0.01);
            EXPECT_GT(box.min().z(), kind == ElementKind::Rubble ? -0.2 : -0.001);
            EXPECT_LE(box.max().z(), element.size.z() + (kind == ElementKind::Rubble ? 0.2 : 0.01));
        }
    }
}

TEST(ArenaMesh, AVictimsSkinIsWarmAndItsMouthOnItsFace) {
    Element victim = sample(static_cast<int>(ElementKind::Victim));
    const ArenaMesh mesh = meshOf(arenaOf(victim));
    ASSERT_EQ(mesh.moving.size(), 1U);  // the arm that waves
    bool skin = false;
    for (const Surface& surface : mesh.still.surfaces) {
        if (surface.material != Material::Skin) continue;
        skin = true;
        EXPECT_NEAR(surface.temperature, 273.15F + 34.0F, 1e-3F);
    }
    EXPECT_TRUE(skin);
    double nearest = 1.0;
    for (const Eigen::Vector3f& corner : mesh.still.corners) {
        nearest = std::min(nearest, (corner.cast<double>() - mouthOf(victim)).norm());
    }
    EXPECT_LT(nearest, 0.03);
    EXPECT_GT(mouthOf(victim).z(), victim.pose.translation().z() + 0.1);
}

TEST(ArenaMesh, ASpectatorStandsOnItsGroundAndPaces) {
    Element person = sample(static_cast<int>(ElementKind::Spectator));
    const ArenaMesh mesh = meshOf(arenaOf(person));
    ASSERT_EQ(mesh.moving.size(), 1U);
    EXPECT_TRUE(mesh.still.triangles.empty());
    const MovingPart& part = mesh.moving.front();
    const Eigen::AlignedBox3d box = boundsOf(part.mesh);
    EXPECT_NEAR(box.min().z(), 0.0, 0.03);
    EXPECT_NEAR(box.max().z(), person.size.z(), 0.05);
    EXPECT_LT((part.at(0.0).translation() - person.pose.translation()).norm(), 1e-9);
    EXPECT_NEAR((part.at(part.period / 4).translation() - person.pose.translation()).norm(), 0.5, 1e-9);
}

TEST(ArenaMesh, AnOpenDoorLeavesItsOpeningFree) {
    Element door = elementOf(ElementKind::Door);
    door.size = {2.0, 0.1, 2.4};
    door.width = 1.0;
    door.angle = degrees(90);
    const Mesh mesh = stillMeshOf(door);
    for (const Eigen::Vector3f& corner : mesh.corners) {
        const bool inOpening =
            std::abs(corner.x()) < 0.45F && std::abs(corner.y()) < 0.06F && corner.z() < 1.9F;
        EXPECT_FALSE(inOpening) << corner.transpose();
    }
    EXPECT_NEAR(boundsOf(mesh).max().y(), 0.99, 0.02);  // the leaf
}

}  // namespace
}  // namespace leitstand::simulation
