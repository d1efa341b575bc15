#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/mesh/element_meshes.h"
#include "robots/simulation/arena/mesh/person.h"
#include "robots/simulation/arena/mesh/sign_pictures.h"
#include "robots/simulation/arena/random.h"

namespace leitstand::simulation {
namespace {

constexpr double AbsoluteZero = -273.15;
constexpr double WarmthOfClothes = 0.4;  ///< share of the way from the air's to the skin's temperature
constexpr double TagEdge = 0.12;         ///< [m]
constexpr double BoardThickness = 0.02;  ///< [m]
constexpr double BoxMargin = 0.06;       ///< gap between a manikin and its box [m]
constexpr double HoleEdge = 0.2;         ///< of the hole in an entombed victim's box [m]

PersonLooks looksOf(const ElementPlace& place, MeshBuilder& builder) {
    const VictimTraits traits = place.element.victim.value_or(VictimTraits{});
    Random random(place.element.seed);
    const auto kelvin = [&](double share) {
        return static_cast<float>(place.arena.ambient + share * (traits.temperature - place.arena.ambient) -
                                  AbsoluteZero);
    };
    const auto cloth = [&](const Eigen::Vector3f& colour) {
        Look look = lookOf(place, Material::Cloth, builder);
        look.surface.colour = colour;
        look.surface.temperature = kelvin(WarmthOfClothes);
        return look;
    };
    PersonLooks looks;
    looks.skin = lookOf(place, Material::Skin, builder);
    looks.skin.surface.temperature = kelvin(1.0);
    const std::array<Eigen::Vector3f, 5> shirts = {Eigen::Vector3f(0.70F, 0.16F, 0.14F),
                                                   {0.18F, 0.42F, 0.30F},
                                                   {0.85F, 0.78F, 0.60F},
                                                   {0.25F, 0.35F, 0.65F},
                                                   {0.80F, 0.50F, 0.15F}};
    const std::array<Eigen::Vector3f, 3> trousers = {
        Eigen::Vector3f(0.16F, 0.20F, 0.34F), {0.30F, 0.26F, 0.20F}, {0.24F, 0.24F, 0.25F}};
    looks.shirt = cloth(shirts[static_cast<std::size_t>(random.below(5))]);
    looks.trousers = cloth(trousers[static_cast<std::size_t>(random.below(3))]);
    looks.shoes = cloth({0.10F, 0.09F, 0.08F});
    looks.hair = cloth({0.22F, 0.15F, 0.09F});
    looks.hair.surface.temperature = kelvin(0.6);
    return looks;
}

double lengthOf(const Element& victim) {
    return victim.size.x();
}

/// Adds a plate with the QR code on the side that robots reach. It stands in front of the arm, so that
/// nothing hides it.
void addTag(MeshBuilder& builder, const ElementPlace& place, double length) {
    const std::string& tag = place.element.victim->tag;
    if (tag.empty()) return;
    const Pose frame = builder.frame();
    Pose lean = Pose::Identity();
    lean.translate(Eigen::Vector3d(0.16 * length, -0.205 * length, 0.005));
    lean.rotate(Eigen::AngleAxisd(degrees(-15), Eigen::Vector3d::UnitX()));
    builder.setFrame(frame * lean);
    Look look = lookOf(place, Material::Plaster, builder);
    look.textureSize = 0.0;
    look.surface.texture = -1;
    builder.setLook(look);
    const double half = TagEdge / 2;
    builder.box({-half, 0.0, 0.0}, {half, 0.006, TagEdge});
    look.surface.texture = builder.texture("sign qr:" + tag, [&] { return signPicture("qr:" + tag); });
    builder.setLook(look);
    builder.face(
        {{-half, -0.001, 0.0}, {half, -0.001, 0.0}, {half, -0.001, TagEdge}, {-half, -0.001, TagEdge}});
    builder.setFrame(frame);
}

/// Adds boards and bricks on legs and trunk; head and one arm stay free.
void addBoards(MeshBuilder& builder, const ElementPlace& place, double length) {
    Random random(place.element.seed ^ 0xB0A2D5ULL);
    builder.setLook(lookOf(place, Material::Plywood, builder));
    const double width = std::max(0.5, 1.2 * place.element.size.y());
    const double top = 0.14 * length;
    for (const double x : {-0.34, -0.16, 0.02}) {
        const Pose board =
            poseFrom({x * length, 0.0, top + random.between(0.0, 0.03)}, degrees(random.between(-12, 12)),
                     degrees(random.between(-6, 6)), degrees(random.between(-14, 14)));
        builder.box(board, {-0.07 * length, -width / 2, 0.0}, {0.07 * length, width / 2, BoardThickness});
    }
    builder.setLook(lookOf(place, Material::Concrete, builder));
    for (const double x : {-0.3, -0.05}) {
        const Pose brick = poseFrom({x * length, random.between(-0.1, 0.1), top + 0.06}, 0.0, 0.0,
                                    degrees(random.between(0, 180)));
        builder.box(brick, {-0.12, -0.057, 0.0}, {0.12, 0.058, 0.071});
    }
}

/// Adds a box around the victim. With @p hole it has only a hole near the head; otherwise the half at the
/// head is open.
void addBox(MeshBuilder& builder, const ElementPlace& place, double length, bool hole) {
    builder.setLook(lookOf(place, Material::Plywood, builder));
    const double x = length / 2 + BoxMargin;
    const double y = std::max(place.element.size.y(), 0.3 * length) / 2 + BoxMargin;
    const double z = std::max(place.element.size.z(), 0.2 * length) + 2 * BoxMargin;
    const double t = BoardThickness;
    builder.box({-x, -y, z - t}, {x, y, z});             // lid
    builder.box({-x, y - t, 0.0}, {x, y, z - t});        // back
    builder.box({-x, -y, 0.0}, {-x + t, y - t, z - t});  // feet
    builder.box({x - t, -y, 0.0}, {x, y - t, z - t});    // head
    if (!hole) {
        builder.box({-x + t, -y, 0.0}, {-0.05 * length, -y + t, z - t});
        return;
    }
    const double from = 0.42 * length - HoleEdge / 2;
    const double to = std::min(from + HoleEdge, x - t - 0.01);
    const double low = 0.06;
    const double high = std::min(low + HoleEdge, z - t - 0.01);
    builder.box({-x + t, -y, 0.0}, {from, -y + t, z - t});
    builder.box({to, -y, 0.0}, {x - t, -y + t, z - t});
    builder.box({from, -y, 0.0}, {to, -y + t, low});
    builder.box({from, -y, high}, {to, -y + t, z - t});
}

/// Returns the shoulder of a side [m]. @p side: 1 left; -1 right, where robots come.
Eigen::Vector3d shoulderOf(double side, double length) {
    const Joints joints;
    return length * Eigen::Vector3d(joints.shoulder.x(), side * joints.shoulder.y(), joints.shoulder.z());
}

MovingPart wavingArm(const ElementPlace& place, double length) {
    MovingPart part;
    MeshBuilder builder(part.mesh);
    const PersonLooks looks = looksOf(place, builder);
    addArm(builder, looks, Eigen::Vector3d(0.25, -0.25, 0.93).normalized(),
           Eigen::Vector3d(0.05, -0.1, 0.99).normalized(), length);
    part.hinge = place.element.pose;
    part.hinge.translate(shoulderOf(-1.0, length));
    part.axis = Eigen::Vector3d::UnitY();
    part.swing = degrees(30);
    part.period = 1.4;
    return part;
}

}  // namespace

Eigen::Vector3d mouthOf(const Element& victim) {
    return victim.pose * (lengthOf(victim) * Joints{}.mouth);
}

void addVictim(MeshBuilder& builder, const ElementPlace& place, std::vector<MovingPart>& moving) {
    if (!place.element.victim) return;
    const VictimTraits& traits = *place.element.victim;
    const double length = lengthOf(place.element);
    const PersonLooks looks = looksOf(place, builder);
    addTrunk(builder, looks, length);
    for (const double side : {-1.0, 1.0}) {
        if (side < 0.0 && traits.waving) continue;
        Pose shoulder = Pose::Identity();
        shoulder.translate(shoulderOf(side, length));
        builder.setFrame(place.element.pose * shoulder);
        addArm(builder, looks, Eigen::Vector3d(-0.94, side * 0.3, -0.1).normalized(),
               Eigen::Vector3d(-0.97, side * -0.1, 0.05).normalized(), length);
    }
    builder.setFrame(place.element.pose);
    if (traits.waving) moving.push_back(wavingArm(place, length));
    addTag(builder, place, length);
    switch (traits.situation) {
        case Situation::Surface:
            break;
        case Situation::Trapped:
            addBoards(builder, place, length);
            break;
        case Situation::Void:
            addBox(builder, place, length, false);
            break;
        case Situation::Entombed:
            addBox(builder, place, length, true);
            break;
    }
}

void addSpectator(const ElementPlace& place, std::vector<MovingPart>& moving) {
    constexpr double Pace = 0.7;  ///< [m/s] at most
    const Element& element = place.element;
    MovingPart part;
    MeshBuilder builder(part.mesh);
    Element person = element;
    person.victim = VictimTraits{};
    const ElementPlace copy{place.arena, person, place.index};
    const PersonLooks looks = looksOf(copy, builder);
    const double length = element.size.z();
    // Upright, looking along the frame's x.
    Pose upright = Pose::Identity();
    upright.translate(Eigen::Vector3d(-0.06 * length, 0.0, 0.508 * length));
    upright.rotate(Eigen::AngleAxisd(degrees(-90), Eigen::Vector3d::UnitY()));
    upright.rotate(Eigen::AngleAxisd(degrees(180), Eigen::Vector3d::UnitX()));
    builder.setFrame(upright);
    addTrunk(builder, looks, length);
    for (const double side : {-1.0, 1.0}) {
        Pose shoulder = upright;
        shoulder.translate(shoulderOf(side, length));
        builder.setFrame(shoulder);
        addArm(builder, looks, Eigen::Vector3d(-0.97, side * 0.22, 0.0).normalized(),
               Eigen::Vector3d(-0.97, side * 0.05, 0.22).normalized(), length);
    }
    part.hinge = element.pose;
    part.axis = Eigen::Vector3d::UnitZ();
    part.sway = element.pose.linear() * Eigen::Vector3d(element.width, 0.0, 0.0);
    part.period = element.width > 0.0 ? 2.0 * 3.14159265358979 * element.width / Pace : 0.0;
    moving.push_back(std::move(part));
}

}  // namespace leitstand::simulation
