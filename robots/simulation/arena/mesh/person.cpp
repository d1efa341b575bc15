#include "robots/simulation/arena/mesh/person.h"

namespace leitstand::simulation {
namespace {

Eigen::Vector3d mirrored(const Eigen::Vector3d& left, double side) {
    return {left.x(), side * left.y(), left.z()};
}

}  // namespace

void addTrunk(MeshBuilder& builder, const PersonLooks& looks, double length) {
    const Joints joints;
    builder.setLook(looks.shirt);
    builder.ellipsoid(length * Eigen::Vector3d(0.22, 0.0, 0.065),
                      length * Eigen::Vector3d(0.15, 0.105, 0.065));
    builder.ellipsoid(length * Eigen::Vector3d(0.10, 0.0, 0.06), length * Eigen::Vector3d(0.14, 0.09, 0.058));
    for (const double side : {-1.0, 1.0}) {
        builder.limb(length * Eigen::Vector3d(0.31, side * 0.02, 0.06),
                     length * mirrored(joints.shoulder, side), length * 0.045, length * 0.035);
    }
    builder.setLook(looks.trousers);
    builder.ellipsoid(length * Eigen::Vector3d(-0.01, 0.0, 0.06),
                      length * Eigen::Vector3d(0.085, 0.095, 0.058));
    for (const double side : {-1.0, 1.0}) {
        builder.limb(length * mirrored(joints.hip, side), length * mirrored(joints.knee, side), length * 0.05,
                     length * 0.035);
        builder.limb(length * mirrored(joints.knee, side), length * mirrored(joints.ankle, side),
                     length * 0.034, length * 0.025);
    }
    builder.setLook(looks.shoes);
    for (const double side : {-1.0, 1.0}) {
        builder.ellipsoid(length * (mirrored(joints.ankle, side) + Eigen::Vector3d(-0.022, 0.0, 0.03)),
                          length * Eigen::Vector3d(0.025, 0.028, 0.06), 10);
    }
    builder.setLook(looks.skin);
    builder.limb(length * joints.neck, length * Eigen::Vector3d(0.40, 0.0, 0.062), length * 0.034,
                 length * 0.032);
    builder.ellipsoid(length * joints.head, length * Eigen::Vector3d(0.066, 0.047, 0.058));
    builder.ellipsoid(length * (joints.head + Eigen::Vector3d(-0.002, 0.0, 0.056)),
                      length * Eigen::Vector3d(0.014, 0.008, 0.012), 8);  // the nose
    builder.setLook(looks.hair);
    builder.ellipsoid(length * (joints.head + Eigen::Vector3d(0.016, 0.0, -0.016)),
                      length * Eigen::Vector3d(0.058, 0.05, 0.05));
}

void addArm(MeshBuilder& builder, const PersonLooks& looks, const Eigen::Vector3d& upper,
            const Eigen::Vector3d& lower, double length) {
    const Eigen::Vector3d elbow = 0.17 * length * upper;
    const Eigen::Vector3d wrist = elbow + 0.145 * length * lower;
    builder.setLook(looks.shirt);
    builder.limb(Eigen::Vector3d::Zero(), elbow, 0.032 * length, 0.026 * length);
    builder.setLook(looks.skin);
    builder.limb(elbow, wrist, 0.025 * length, 0.018 * length);
    builder.limb(wrist, wrist + 0.055 * length * lower, 0.022 * length, 0.016 * length);
}

}  // namespace leitstand::simulation
