#include <cmath>
#include <initializer_list>

#include "robots/simulation/world/body.h"
#include "robots/simulation/world/shapes.h"

namespace leitstand::simulation {
namespace {

/// Adds contacts for the underside of a wheel at (x, y): points on its rim, as high as it climbs.
void addWheel(BodySpec& spec, double x, double y) {
    const double radius = spec.wheelRadius;
    for (const double share : {0.0, -0.25, 0.25, -0.5, 0.5, -0.7, 0.7, -0.85, 0.85, -0.95, 0.95}) {
        const double along = share * radius;
        spec.contacts.emplace_back(x + along, y, radius - std::sqrt(radius * radius - along * along));
    }
}

/// Adds contacts for the underside of a chain from -half to half along x, at y: flat, with round ends. Points
/// of neighbouring tracks lie between each other's, by @p shift.
void addChain(BodySpec& spec, double half, double y, double shift) {
    const double flat = half - spec.wheelRadius;
    const int count = static_cast<int>((2.0 * flat - shift) / 0.03 + 1e-9);
    for (int i = 0; i <= count; ++i) spec.contacts.emplace_back(-flat + shift + 0.03 * i, y, 0.0);
    for (const double share : {0.0, 0.35, 0.6, 0.8, 0.93, 1.0}) {
        const double along = share * spec.wheelRadius;
        const double lift = spec.wheelRadius - std::sqrt(spec.wheelRadius * spec.wheelRadius - along * along);
        spec.contacts.emplace_back(flat + along, y, lift);
        spec.contacts.emplace_back(-flat - along, y, lift);
    }
}

Surface painted(Material material, float red, float green, float blue, float kelvin) {
    Surface surface;
    surface.material = material;
    surface.colour = {red, green, blue};
    surface.temperature = kelvin;
    return surface;
}

}  // namespace

BodySpec kurt3dBody() {
    BodySpec spec;
    spec.name = "kurt3d";
    spec.mass = 25.0;
    spec.centreOfMass = {0.0, 0.0, 0.17};
    spec.trackWidth = 0.27;
    spec.wheelRadius = 0.08;
    // The middle wheels stand further out, so that the robot is short (paper, section 2).
    for (const double side : {1.0, -1.0}) {
        addWheel(spec, 0.145, side * 0.13);
        addWheel(spec, 0.0, side * 0.145);
        addWheel(spec, -0.145, side * 0.13);
    }
    for (const double x : {-0.18, -0.09, 0.0, 0.09, 0.18}) spec.belly.emplace_back(x, 0.0, 0.06);
    spec.outline = {{0.225, -0.15}, {0.225, 0.15},   {0.08, 0.165},   {-0.08, 0.165},
                    {-0.225, 0.15}, {-0.225, -0.15}, {-0.08, -0.165}, {0.08, -0.165}};
    spec.bumpFrom = 0.03;
    spec.bumpTo = 0.56;
    spec.maxClimb = 0.035;
    spec.maxTilt = 0.96;
    spec.grip = 0.9;
    spec.skidTorque = 9.0;  // front and rear wheels have no tread pattern, to turn more easily
    spec.motor = {200.0, 0.64, 20.0, 4.0, 8.0};
    spec.slip = {0.03, 0.02, 0.10, 0.25};

    const int body = addSurface(spec.shape, painted(Material::Metal, 0.75F, 0.10F, 0.08F, 300.0F));
    const int tyre = addSurface(spec.shape, painted(Material::Rubber, 0.06F, 0.06F, 0.06F, 295.0F));
    const int dark = addSurface(spec.shape, painted(Material::Metal, 0.15F, 0.15F, 0.17F, 303.0F));
    addBox(spec.shape, body, {-0.20, -0.095, 0.06}, {0.20, 0.095, 0.20});
    addBox(spec.shape, dark, {-0.19, -0.09, 0.20}, {0.10, 0.09, 0.25});  // laptops
    for (const double side : {1.0, -1.0}) {
        for (const double x : {-0.145, 0.0, 0.145}) {
            const double inner = x == 0.0 ? 0.125 : 0.105;
            addCylinder(spec.shape, tyre, {x, side * inner, 0.08}, {x, side * (inner + 0.04), 0.08}, 0.08,
                        14);
        }
        // Pan-tilt units with their cameras.
        addCylinder(spec.shape, dark, {0.16, side * 0.08, 0.20}, {0.16, side * 0.08, 0.30}, 0.015, 8);
        addBox(spec.shape, dark, {0.135, side * 0.08 - 0.03, 0.30}, {0.185, side * 0.08 + 0.03, 0.35});
    }
    addCylinder(spec.shape, body, {0, 0, 0.25}, {0, 0, 0.40}, 0.05, 12);
    addCylinder(spec.shape, dark, {0, 0, 0.40}, {0, 0, 0.56}, 0.09, 16);  // the scanner's head
    return spec;
}

BodySpec crawlerBody() {
    BodySpec spec;
    spec.name = "crawler";
    spec.mass = 7.0;
    // Batteries and motors are low and in front. With the weight higher or further back, it would fall over
    // backwards on steps of 10 cm before its middle is above them.
    spec.centreOfMass = {0.035, 0.0, 0.045};
    spec.trackWidth = 0.20;
    spec.wheelRadius = 0.055;
    for (const double side : {1.0, -1.0}) {
        addChain(spec, 0.20, side * 0.08, 0.0);
        addChain(spec, 0.20, side * 0.12, 0.015);
    }
    for (const double x : {-0.15, -0.05, 0.05, 0.15}) spec.belly.emplace_back(x, 0.0, 0.035);
    spec.outline = {{0.20, -0.13}, {0.20, 0.13}, {-0.20, 0.13}, {-0.20, -0.13}};
    spec.bumpFrom = 0.03;
    spec.bumpTo = 0.37;
    spec.maxClimb = 0.11;
    spec.maxTilt = 1.05;
    spec.grip = 1.1;  // knobs of rubber
    spec.skidTorque = 3.5;
    spec.motor = {60.0, 0.7, 8.0, 2.0, 3.0};
    spec.slip = {0.03, 0.02, 0.10, 0.30};

    const int body = addSurface(spec.shape, painted(Material::Metal, 0.80F, 0.65F, 0.10F, 300.0F));
    const int chain = addSurface(spec.shape, painted(Material::Rubber, 0.08F, 0.08F, 0.08F, 296.0F));
    const int dark = addSurface(spec.shape, painted(Material::Metal, 0.15F, 0.15F, 0.17F, 303.0F));
    addBox(spec.shape, body, {-0.18, -0.065, 0.035}, {0.18, 0.065, 0.145});
    for (const double side : {1.0, -1.0}) {
        for (const double x : {-0.145, 0.145}) {
            addCylinder(spec.shape, chain, {x, side * 0.07, 0.055}, {x, side * 0.13, 0.055}, 0.055, 14);
        }
        addBox(spec.shape, chain, {-0.145, side * 0.10 - 0.03, 0.0}, {0.145, side * 0.10 + 0.03, 0.11});
    }
    addBox(spec.shape, dark, {0.115, -0.025, 0.145}, {0.165, 0.025, 0.195});  // the laser
    addCylinder(spec.shape, dark, {0, 0, 0.145}, {0, 0, 0.26}, 0.02, 8);      // camera, looking up
    addCylinder(spec.shape, dark, {0, 0, 0.35}, {0, 0, 0.37}, 0.035, 12);     // its mirror
    return spec;
}

}  // namespace leitstand::simulation
