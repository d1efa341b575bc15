#include "transport/domain/join_settings.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

// As sros2 leaves a keystore in which no enclave was made for us: rmw_fastrtps joins openly unless security
// is enforced.
TEST(JoinSettings, KeysThatAreNotThereLeaveTheDomainOpenUnlessTheyAreEnforced) {
    const TemporaryFolder store;
    std::filesystem::create_directories(store / "enclaves");
    DomainSettings settings;
    settings.keys = store / "enclaves";
    settings.openWithoutKeys = true;
    settings.fromEnvironment = {"ROS_SECURITY_KEYSTORE=" + store.path().string()};
    EXPECT_FALSE(isSecured(settings));
    const auto open = nodeSettings(settings, "test");
    ASSERT_TRUE(open.ok()) << open.error().text;
    EXPECT_FALSE(open->security.has_value());
    EXPECT_THAT(securityLine(settings), HasSubstr("OFF"));
    settings.openWithoutKeys = false;
    EXPECT_TRUE(isSecured(settings));
    EXPECT_THAT(nodeSettings(settings, "test").error().text, HasSubstr("ROS_SECURITY_ENCLAVE_OVERRIDE"));
    settings.fromEnvironment.clear();
    EXPECT_THAT(nodeSettings(settings, "test").error().text,
                testing::Not(HasSubstr("ROS_SECURITY_ENCLAVE_OVERRIDE")))
        << "an option chose them";
}

TEST(JoinSettings, WhatIsChosenReachesTheNode) {
    DomainSettings settings;
    settings.domain = 7;
    settings.initialPeers = {"192.168.0.7"};
    settings.multicast = false;
    const auto node = nodeSettings(settings, "test");
    ASSERT_TRUE(node.ok());
    EXPECT_EQ(node->domain, 7);
    EXPECT_EQ(node->initialPeers, settings.initialPeers);
    EXPECT_FALSE(node->multicast);
    EXPECT_FALSE(isSecured(settings));
}

}  // namespace
}  // namespace leitstand::test
