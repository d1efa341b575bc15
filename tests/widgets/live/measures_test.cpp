// How large a robot is, as it is entered in the form.
#include "widgets/models/live/robots/measures.h"

#include <gtest/gtest.h>

#include "core/robot/model/model_body.h"

namespace leitstand::test {
namespace {

TEST(Measures, ARectangleIsItsFourSides) {
    const Sides sides{0.4, 0.3, 0.2, 0.25};
    const auto footprint = footprintOf(sides);
    EXPECT_TRUE(isRectangle(footprint));
    EXPECT_EQ(sidesOf(footprint), sides);
    EXPECT_FALSE(isRectangle({{0.4, 0.0}, {0.0, 0.4}, {-0.4, 0.0}, {0.0, -0.4}})) << "turned";
    EXPECT_FALSE(isRectangle({{0.4, 0.0}, {0.0, 0.4}, {-0.4, 0.0}}));
}

TEST(Measures, SensorsThatOnlyStreamsNameAreThereToBePlaced) {
    RobotDescription robot;
    robot.footprint = footprintOf({0.4, 0.3, 0.2, 0.2});
    robot.height = 0.5;
    robot.sensors["lidar"].frame = "velodyne";
    robot.sensors["lidar"].sensorInBase.translation().z() = 0.4;
    StreamDescription front;
    front.sensor = "front";
    robot.streams = {front, front};
    const Measures measures = measuresOf(robot);
    ASSERT_EQ(measures.sensors.size(), 2U);
    EXPECT_EQ(measures.sensors[0].name, "front");
    EXPECT_EQ(measures.sensors[1].frame, "velodyne");
    EXPECT_EQ(measures.sensors[1].sensorInBase.translation().z(), 0.4);
}

TEST(Measures, TheModelGivesOutlineHeightAndThePlacesOfItsLinks) {
    RobotModel model;
    model.links = {{"base_link", {}, {}}, {"velodyne", {}, {}}};
    LinkPart hull;
    hull.shape = BoxShape{{0.8, 0.4, 0.3}};
    model.links[0].visuals = {hull};
    ModelJoint mast;
    mast.child = 1;
    mast.jointInParent.translation().z() = 0.5;
    model.joints = {mast};
    Measures measures;
    measures.sensors = {{"camera", "camera_optical", Pose::Identity()},
                        {"lidar", "rover/velodyne", Pose::Identity()}};
    const auto none = [](const std::string& uri) -> Result<TriangleMesh> { return Error{uri}; };
    std::string problem;
    const Measures taken = withModel(measures, bodyOf(model, "base_link", none), problem);
    EXPECT_EQ(problem, "");
    EXPECT_NEAR(taken.height, 0.3, 1e-6);
    EXPECT_NEAR(sidesOf(taken.footprint).front, 0.4, 1e-6);
    EXPECT_EQ(taken.sensors[1].sensorInBase.translation().z(), 0.5);
    EXPECT_TRUE(taken.sensors[0].sensorInBase.isApprox(Pose::Identity())) << "the model has no such link";
    LinkPart mesh;
    mesh.shape = MeshShape{"package://a/b.dae"};
    model.links[1].visuals = {mesh};
    const Measures partial = withModel(measures, bodyOf(model, "base_link", none), problem);
    EXPECT_NE(problem, "") << "part of the robot is not here";
    EXPECT_EQ(partial.height, measures.height);
    EXPECT_EQ(partial.sensors[1].sensorInBase.translation().z(), 0.5) << "places are known all the same";
}

}  // namespace
}  // namespace leitstand::test
