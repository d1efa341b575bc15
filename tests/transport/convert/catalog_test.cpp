#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transport/convert/message_catalog.h"

namespace leitstand {
namespace {

TEST(MessageCatalog, FindsTypesByBothNames) {
    const MessageType* byRos = findMessageType("sensor_msgs/msg/PointCloud2");
    ASSERT_NE(byRos, nullptr);
    EXPECT_EQ(byRos->ddsName, "sensor_msgs::msg::dds_::PointCloud2_");
    EXPECT_EQ(findMessageType("sensor_msgs::msg::dds_::PointCloud2_"), byRos);
    EXPECT_EQ(findMessageType("sensor_msgs/PointCloud2"), nullptr);
    EXPECT_EQ(findMessageType(""), nullptr);
    EXPECT_TRUE(
        std::is_sorted(messageTypes().begin(), messageTypes().end(),
                       [](const MessageType& a, const MessageType& b) { return a.rosName < b.rosName; }));
}

// Published by ROS 2 itself (Iron and later).
TEST(MessageCatalog, HashesAreThoseOfRos) {
    EXPECT_EQ(findMessageType("std_msgs/msg/String")->hash,
              "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");
    EXPECT_EQ(findMessageType("geometry_msgs/msg/Twist")->hash,
              "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a");
    EXPECT_EQ(findMessageType("std_msgs/msg/Empty")->hash,
              "RIHS01_20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312");
}

TEST(MessageCatalog, DefinitionsHoldAllThatTheyNeed) {
    EXPECT_EQ(findMessageType("geometry_msgs/msg/TwistStamped")->definition,
              "std_msgs/Header header\n"
              "geometry_msgs/Twist twist\n"
              "================================================================================\n"
              "MSG: builtin_interfaces/Time\n"
              "int32 sec\n"
              "uint32 nanosec\n"
              "================================================================================\n"
              "MSG: geometry_msgs/Twist\n"
              "geometry_msgs/Vector3 linear\n"
              "geometry_msgs/Vector3 angular\n"
              "================================================================================\n"
              "MSG: geometry_msgs/Vector3\n"
              "float64 x\n"
              "float64 y\n"
              "float64 z\n"
              "================================================================================\n"
              "MSG: std_msgs/Header\n"
              "builtin_interfaces/Time stamp\n"
              "string frame_id\n");
    EXPECT_THAT(std::string(findMessageType("sensor_msgs/msg/CameraInfo")->definition),
                testing::AllOf(testing::HasSubstr("float64[] d\nfloat64[9] k\n"),
                               testing::HasSubstr("bool do_rectify\n")));
    EXPECT_EQ(findMessageType("std_msgs/msg/Empty")->definition, "");
}

}  // namespace
}  // namespace leitstand
