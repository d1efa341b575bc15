#include "core/settings/ros_environment.h"

#include <cstdlib>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/settings/domain_settings.h"

namespace leitstand {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Variables = std::map<std::string, std::string>;

Result<RosEnvironment> environmentOf(const Variables& variables) {
    return rosEnvironment([&](const char* name) -> const char* {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    });
}

/// How a program joins with @p options where @p variables are set.
DomainSettings joined(const Variables& variables, const DomainOptions& options = {}) {
    const auto environment = environmentOf(variables);
    EXPECT_TRUE(environment.ok()) << environment.error().text;
    const auto settings = domainSettings(options, environment ? *environment : RosEnvironment{});
    EXPECT_TRUE(settings.ok()) << settings.error().text;
    return settings ? *settings : DomainSettings{};
}

std::string complaint(const Variables& variables, const DomainOptions& options = {}) {
    const auto environment = environmentOf(variables);
    if (!environment) return environment.error().text;
    const auto settings = domainSettings(options, *environment);
    return settings ? std::string() : settings.error().text;
}

TEST(RosEnvironment, WithoutItAllIsAsUsual) {
    const DomainSettings settings = joined({});
    EXPECT_EQ(settings.domain, 0);
    EXPECT_THAT(settings.interfaces, IsEmpty());
    EXPECT_THAT(settings.initialPeers, IsEmpty());
    EXPECT_TRUE(settings.multicast);
    EXPECT_TRUE(settings.keys.empty());
    EXPECT_THAT(settings.fromEnvironment, IsEmpty());
    EXPECT_THAT(joined({{"ROS_DOMAIN_ID", ""}, {"ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET"}}).fromEnvironment,
                IsEmpty())
        << "what is empty or usual decides nothing";
}

TEST(RosEnvironment, TheDomainCountsUnlessAnOptionNamesOne) {
    EXPECT_EQ(joined({{"ROS_DOMAIN_ID", "7"}}).domain, 7);
    EXPECT_THAT(joined({{"ROS_DOMAIN_ID", "7"}}).fromEnvironment, ElementsAre("ROS_DOMAIN_ID=7"));
    DomainOptions zero;
    zero.domain = 0;
    EXPECT_EQ(joined({{"ROS_DOMAIN_ID", "7"}}, zero).domain, 0);
    EXPECT_THAT(joined({{"ROS_DOMAIN_ID", "7"}}, zero).fromEnvironment, IsEmpty());
}

TEST(RosEnvironment, ADomainThatIsNoneIsNamed) {
    for (const char* text : {"233", "-1", "seven", "7 ", "0x7", "010", "99999999999999999999"})
        EXPECT_THAT(complaint({{"ROS_DOMAIN_ID", text}}),
                    testing::AllOf(HasSubstr("ROS_DOMAIN_ID"), HasSubstr(text), HasSubstr("0..232")));
}

TEST(RosEnvironment, RobotsOfThisComputerAloneAreFoundOnItsOwnInterface) {
    for (const Variables& variables : {Variables{{"ROS_LOCALHOST_ONLY", "1"}},
                                       Variables{{"ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST"}}}) {
        EXPECT_THAT(joined(variables).interfaces, ElementsAre("lo"));
        EXPECT_EQ(joined(variables).fromEnvironment.size(), 1U);
    }
    EXPECT_THAT(joined({{"ROS_LOCALHOST_ONLY", "0"}}).interfaces, IsEmpty());
}

TEST(RosEnvironment, PeersAreAskedBesideAllOthersOrAlone) {
    const Variables two = {{"ROS_STATIC_PEERS", "192.168.0.7; 192.168.0.8;;"}};
    EXPECT_THAT(joined(two).initialPeers, ElementsAre("192.168.0.7", "192.168.0.8"));
    EXPECT_TRUE(joined(two).multicast);
    const DomainSettings alone =
        joined({{"ROS_STATIC_PEERS", "192.168.0.7"}, {"ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST"}});
    EXPECT_THAT(alone.initialPeers, ElementsAre("192.168.0.7", "127.0.0.1"));
    EXPECT_FALSE(alone.multicast) << "nobody else in the network is asked";
    EXPECT_THAT(alone.interfaces, IsEmpty()) << "the peer is not on this computer";
    EXPECT_THAT(joined({{"ROS_STATIC_PEERS", "192.168.0.7"}, {"ROS_LOCALHOST_ONLY", "1"}}).initialPeers,
                IsEmpty())
        << "as in ROS";
}

TEST(RosEnvironment, AServerIsAskedWhateverTheRangeButOnThisComputerAloneIfSoSaid) {
    const Variables server = {{"ROS_DISCOVERY_SERVER", "10.0.0.1:11811"}};
    Variables range = server, only = server;
    range["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST";
    only["ROS_LOCALHOST_ONLY"] = "1";
    EXPECT_THAT(joined(range).interfaces, IsEmpty());
    EXPECT_THAT(joined(range).fromEnvironment, ElementsAre("ROS_DISCOVERY_SERVER=10.0.0.1:11811"))
        << "the range decided nothing";
    EXPECT_THAT(joined(only).interfaces, ElementsAre("lo"));
    EXPECT_EQ(joined(only).fromEnvironment.size(), 2U);
}

TEST(RosEnvironment, TheLibraryDoesNotReadTheServerByItself) {
    ASSERT_EQ(setenv("ROS_DISCOVERY_SERVER", "10.0.0.1:11811", 1), 0);
    const auto environment = rosEnvironment();
    ASSERT_TRUE(environment.ok());
    EXPECT_EQ(environment->discoveryServer, "10.0.0.1:11811");
    EXPECT_EQ(std::getenv("ROS_DISCOVERY_SERVER"), nullptr);
}

TEST(RosEnvironment, OptionsThatSayWhomToFindGoBeforeIt) {
    DomainOptions card;
    card.interfaces = {"wlan0"};
    const DomainSettings settings =
        joined({{"ROS_LOCALHOST_ONLY", "1"}, {"ROS_DISCOVERY_SERVER", "10.0.0.1:11811"}}, card);
    EXPECT_THAT(settings.interfaces, ElementsAre("wlan0"));
    EXPECT_EQ(settings.discoveryServer, "");
    EXPECT_THAT(settings.fromEnvironment, IsEmpty());
    EXPECT_EQ(joined({{"ROS_DISCOVERY_SERVER", "10.0.0.1:11811"}}).discoveryServer, "10.0.0.1:11811");
}

TEST(RosEnvironment, AStationThatCouldFindNobodyDoesNotBegin) {
    const Variables off = {{"ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF"}};
    EXPECT_THAT(complaint(off), testing::AllOf(HasSubstr("ROS_AUTOMATIC_DISCOVERY_RANGE"), HasSubstr("OFF"),
                                               HasSubstr("--interface")));
    DomainOptions peer;
    peer.initialPeers = {"192.168.0.7"};
    EXPECT_EQ(complaint(off, peer), "");
    EXPECT_THAT(complaint({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "localhost"}}), HasSubstr("LOCALHOST"));
    EXPECT_THAT(complaint({{"ROS_LOCALHOST_ONLY", "yes"}}), HasSubstr("ROS_LOCALHOST_ONLY"));
}

TEST(RosEnvironment, KeysAreThoseOfTheEnclave) {
    Variables variables = {{"ROS_SECURITY_KEYSTORE", "/keys"},
                           {"ROS_SECURITY_ENCLAVE_OVERRIDE", "/team/desk"}};
    EXPECT_TRUE(joined(variables).keys.empty()) << "ROS_SECURITY_ENABLE is not set";
    variables["ROS_SECURITY_ENABLE"] = "true";
    EXPECT_EQ(joined(variables).keys, "/keys/enclaves/team/desk");
    EXPECT_TRUE(joined(variables).openWithoutKeys) << "Permissive";
    variables["ROS_SECURITY_STRATEGY"] = "Enforce";
    EXPECT_FALSE(joined(variables).openWithoutKeys);
    DomainOptions own;
    own.keys = "/mine";
    EXPECT_EQ(joined(variables, own).keys, "/mine");
    EXPECT_FALSE(joined(variables, own).openWithoutKeys);
    variables["ROS_SECURITY_ENCLAVE_OVERRIDE"] = "desk";
    EXPECT_THAT(complaint(variables), HasSubstr("ROS_SECURITY_ENCLAVE_OVERRIDE"));
    EXPECT_THAT(complaint({{"ROS_SECURITY_ENABLE", "true"}, {"ROS_SECURITY_STRATEGY", "Enforce"}}),
                HasSubstr("ROS_SECURITY_KEYSTORE"));
}

}  // namespace
}  // namespace leitstand
