#include "core/mapping/graph/link_error.h"

#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace leitstand {
namespace {

class LinkErrors : public testing::Test {
protected:
    double number() { return m_normal(m_random); }
    Pose pose(double turn) {
        Pose pose = Pose::Identity();
        pose.translation() = Eigen::Vector3d(number(), number(), number());
        const Eigen::Vector3d axis = Eigen::Vector3d(number(), number(), number()).normalized();
        pose.linear() = Eigen::AngleAxisd(turn, axis).toRotationMatrix();
        return pose;
    }

private:
    std::mt19937 m_random{5};
    std::normal_distribution<double> m_normal;
};

TEST_F(LinkErrors, AreNothingWhereThePosesAreAsTheLinkSays) {
    for (int i = 0; i < 50; ++i) {
        const Pose from = pose(2.0), link = pose(3.0);
        EXPECT_LT(linkError(from, from * link, link).norm(), 1e-12);
    }
}

TEST_F(LinkErrors, AreTheDifferenceInMetresAndRadiansWhereItIsSmall) {
    const Pose from = pose(1.0), link = pose(2.0);
    LinkVector step;
    step << 0.01, -0.02, 0.03, 0.001, 0.002, -0.003;
    const LinkVector error = linkError(from, movedBy(from * link, step), link);
    EXPECT_LT((error - step).norm(), 1e-2 * step.norm() + 1e-6) << error.transpose();
}

TEST_F(LinkErrors, TakeTheShorterOfTwoTurns) {
    const Pose from = pose(0.5);
    Pose to = from;
    to.linear() = from.linear() * Eigen::AngleAxisd(6.2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    EXPECT_LT(linkError(from, to, Pose::Identity()).norm(), 0.1)
        << "6.2 rad to the left are 0.08 to the right";
}

TEST_F(LinkErrors, ChangeAsTheirDerivativesSay) {
    constexpr double Small = 1e-6;
    for (int i = 0; i < 50; ++i) {
        const Pose from = pose(1.0), link = pose(2.0), to = from * link * pose(1.5);
        const LinearLink linear = linearLink(from, to, link);
        EXPECT_LT((linear.error - linkError(from, to, link)).norm(), 1e-12);
        for (Eigen::Index axis = 0; axis < 6; ++axis) {
            LinkVector step = LinkVector::Zero();
            step[axis] = Small;
            const LinkVector byFrom =
                (linkError(movedBy(from, step), to, link) - linkError(movedBy(from, -step), to, link)) /
                (2 * Small);
            const LinkVector byTo =
                (linkError(from, movedBy(to, step), link) - linkError(from, movedBy(to, -step), link)) /
                (2 * Small);
            EXPECT_LT((byFrom - linear.byFrom.col(axis)).norm(), 1e-7);
            EXPECT_LT((byTo - linear.byTo.col(axis)).norm(), 1e-7);
        }
    }
}

}  // namespace
}  // namespace leitstand
