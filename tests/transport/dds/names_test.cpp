#include "transport/dds/names.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "transport/dds/guid.h"
#include "transport/dds/network/interfaces.h"
#include "transport/dds/network/socket_buffers.h"

namespace leitstand::test {
namespace {

TEST(DdsNames, TopicsAndBack) {
    EXPECT_EQ(ddsTopicOf("/kurt3d/odom"), "rt/kurt3d/odom");
    EXPECT_EQ(rosTopicOf("rt/kurt3d/odom"), "/kurt3d/odom");
    for (const std::string other : {"Square", "rq/k/set_modeRequest", "rt", "", "ros_discovery_info"}) {
        EXPECT_EQ(rosTopicOf(other), other);
        EXPECT_EQ(ddsTopicOf(other), other);
    }
}

TEST(DdsNames, TypesAndBack) {
    EXPECT_EQ(ddsTypeOf("sensor_msgs/msg/PointCloud2"), "sensor_msgs::msg::dds_::PointCloud2_");
    EXPECT_EQ(rosTypeOf("sensor_msgs::msg::dds_::PointCloud2_"), "sensor_msgs/msg/PointCloud2");
    EXPECT_EQ(rosTypeOf("a::srv::dds_::Set_Request_"), "a/srv/Set_Request");
    for (const std::string other :
         {"ShapeType", "a::b::c_", "a::msg::dds_::_", "::msg::dds_::A_", "a/b", "a//c", ""}) {
        EXPECT_EQ(rosTypeOf(other), other);
        EXPECT_EQ(ddsTypeOf(other), other);
    }
}

TEST(DdsNames, GuidsAreReadable) {
    Guid guid;
    for (std::size_t i = 0; i < guid.bytes.size(); ++i) guid.bytes[i] = static_cast<std::uint8_t>(i * 16 + 1);
    EXPECT_EQ(toString(guid), "01112131.41516171.8191a1b1.c1d1e1f1");
}

TEST(SocketBuffers, SmallLimitsAreToldWithTheirRemedy) {
    const TemporaryFolder folder;
    EXPECT_TRUE(detail::socketBufferWarnings(folder.path()).empty());
    writeText(folder / "rmem_max", "212992\n");
    writeText(folder / "wmem_max", "4194304\n");
    const auto warnings = detail::socketBufferWarnings(folder.path());
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(
        warnings[0],
        "net.core.rmem_max is 212992 bytes: large scans and pictures will be lost or late. Lift it with: "
        "sudo sysctl -w net.core.rmem_max=4194304");
}

TEST(Interfaces, ByNameOrAddress) {
    EXPECT_EQ(*detail::addressesOf({"lo"}), std::vector<std::string>{"127.0.0.1"});
    EXPECT_EQ(*detail::addressesOf({"127.0.0.1"}), std::vector<std::string>{"127.0.0.1"});
    const auto none = detail::addressesOf({"wlan77"});
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text.find("interfaces: \"wlan77\" has no IPv4 address here; there are"),
              std::string::npos);
    EXPECT_NE(none.error().text.find("lo (127.0.0.1)"), std::string::npos);
}

TEST(Peers, AddressWithAndWithoutPort) {
    const auto peer = detail::parsePeer("192.168.0.7:7410", "initial peers");
    ASSERT_TRUE(peer);
    EXPECT_EQ(peer->address, "192.168.0.7");
    EXPECT_EQ(peer->port, 7410);
    EXPECT_EQ(detail::parsePeer("localhost", "initial peers")->address, "127.0.0.1");
    EXPECT_EQ(detail::parsePeer("localhost", "initial peers")->port, 0);
    for (const char* wrong : {"", ":7410", "1.2.3.4:", "1.2.3.4:0", "1.2.3.4:70000", "1.2.3.4:x"}) {
        const auto bad = detail::parsePeer(wrong, "initial peers");
        ASSERT_FALSE(bad) << wrong;
        EXPECT_EQ(bad.error().text.find("initial peers: \""), 0U) << bad.error().text;
    }
}

}  // namespace
}  // namespace leitstand::test
