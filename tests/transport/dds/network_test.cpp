#include <cstdlib>

#include <gmock/gmock.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"
#include "transport/dds/detail/fastdds.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
namespace efd = eprosima::fastdds::dds;

std::vector<std::string> talk(const TestDomain& domain, const std::vector<std::string>& options) {
    std::vector<std::string> words = {"talk", std::to_string(domain.number()), "/k/odom", "reliable=0"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

/// Whether @p station hears the talker of /k/odom.
bool receives(Node& station, std::chrono::milliseconds atMost = 20s) {
    Inbox inbox;
    const auto listening = must(station.subscribe({"/k/odom", TestType, bestEffort()}, inbox.callback()));
    return inbox.waitFor(3, atMost);
}

TEST(InitialPeers, FindEachOtherWithoutMulticast) {
    const TestDomain domain;
    const ChildProcess robot(program("dds_peer"), talk(domain, {"multicast=0", "interface=lo"}));
    NodeSettings settings;
    settings.multicast = false;
    settings.interfaces = {"lo"};
    settings.initialPeers = {"127.0.0.1"};
    const auto station = nodeIn(domain, settings);
    EXPECT_TRUE(receives(*station));
}

TEST(InitialPeers, WithoutThemAndMulticastNobodyIsFound) {
    const TestDomain domain;
    const ChildProcess robot(program("dds_peer"), talk(domain, {"multicast=0", "interface=lo"}));
    ASSERT_TRUE(waitUntil([&] { return robot.out().find("ready") != std::string::npos; }));
    NodeSettings settings;
    settings.multicast = false;
    const auto station = nodeIn(domain, settings);
    EXPECT_FALSE(receives(*station, 1s));
}

TEST(InitialPeers, AreBesideMulticast) {
    const TestDomain domain;
    const ChildProcess robot(program("dds_peer"), talk(domain, {}));
    NodeSettings settings;
    settings.initialPeers = {"192.0.2.77:7410"};  // nobody there
    const auto station = nodeIn(domain, settings);
    EXPECT_TRUE(receives(*station));
}

/// A discovery server in this process.
class DiscoveryServer {
public:
    DiscoveryServer(int domain, std::uint32_t port) {
        namespace rtps = detail::fastdds::rtps;
        efd::DomainParticipantQos qos;
        auto& builtin = qos.wire_protocol().builtin;
        detail::fastdds::becomeServer(qos);
        rtps::Locator_t locator;
        locator.kind = LOCATOR_KIND_UDPv4;
        locator.port = port;
        rtps::IPLocator::setIPv4(locator, "127.0.0.1");
        builtin.metatrafficUnicastLocatorList.push_back(locator);
        m_participant = efd::DomainParticipantFactory::get_instance()->create_participant(
            static_cast<efd::DomainId_t>(domain), qos);
    }
    ~DiscoveryServer() { efd::DomainParticipantFactory::get_instance()->delete_participant(m_participant); }
    DiscoveryServer(const DiscoveryServer&) = delete;
    DiscoveryServer& operator=(const DiscoveryServer&) = delete;

private:
    efd::DomainParticipant* m_participant = nullptr;
};

TEST(DiscoveryServer, TellsOfRobotsAndAllTheirTopics) {
    const TestDomain domain;
    const std::uint32_t port = 11'000 + static_cast<std::uint32_t>(domain.number());
    const std::string address = "127.0.0.1:" + std::to_string(port);
    const DiscoveryServer server(domain.number(), port);
    const ChildProcess robot(program("dds_peer"),
                             talk(domain, {"server=" + address, "name=kurt3d", "wait=0"}));
    NodeSettings settings;
    settings.discoveryServer = address;
    const auto station = nodeIn(domain, settings);
    // Also what nobody here subscribes to.
    EXPECT_TRUE(waitUntil([&] {
        const auto endpoints = station->endpoints();
        return endpoints.size() == 1 && endpoints[0].topic == "/k/odom" &&
               endpoints[0].participantName == "kurt3d";
    }));
    EXPECT_TRUE(receives(*station));
}

TEST(Interfaces, TheChosenOneIsEnoughAndUnknownOnesAreNamed) {
    const TestDomain domain;
    NodeSettings settings;
    settings.interfaces = {"lo"};
    const auto station = nodeIn(domain, settings);
    const ChildProcess robot(program("dds_peer"), talk(domain, {"interface=lo"}));
    EXPECT_TRUE(receives(*station));
    ASSERT_EQ(station->endpoints().size(), 1U);
    settings.interfaces = {"wlan77"};
    const auto none = Node::create(settings);
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().text, testing::HasSubstr("interfaces: \"wlan77\" has no IPv4 address here"));
}

TEST(NodeSettings, WhatCannotBeIsToldByItsName) {
    const auto errorOf = [](const NodeSettings& settings) {
        const auto node = Node::create(settings);
        return node ? std::string("no error") : node.error().text;
    };
    NodeSettings settings;
    settings.domain = 233;
    EXPECT_EQ(errorOf(settings), "domain: 233: expected 0 to 232");
    settings = {};
    settings.initialPeers = {"192.168.0.7:port"};
    EXPECT_THAT(errorOf(settings), testing::StartsWith("initial peers: \"192.168.0.7:port\""));
    settings = {};
    settings.discoveryServer = "192.168.0.7:11811;:3";
    EXPECT_THAT(errorOf(settings), testing::StartsWith("discovery server: \":3\""));
    settings = {};
    settings.security.emplace();
    settings.security->identityCa = "/nowhere/ca.pem";
    EXPECT_EQ(errorOf(settings), "security: /nowhere/ca.pem: cannot be opened");
}

/// Profiles are read once a process, so each case is in one of its own: the talker.
class XmlProfiles : public testing::Test {
protected:
    [[nodiscard]] std::vector<std::string> profiles(const std::string& content) const {
        writeText(m_folder / "profiles.xml",
                  R"(<?xml version="1.0" encoding="UTF-8"?>
<profiles xmlns=")" + std::string(detail::fastdds::ProfilesNamespace) +
                      "\">" + content + "</profiles>");
        return {std::string(detail::fastdds::ProfilesVariable) + "=" + (m_folder / "profiles.xml").string()};
    }
    TestDomain m_domain;
    TemporaryFolder m_folder;
};

TEST_F(XmlProfiles, TheParticipantIsTheUsers) {
    const auto station = nodeIn(m_domain);
    const ChildProcess robot(program("dds_peer"), talk(m_domain, {"name=ours"}),
                             profiles(R"(<participant profile_name="mine" is_default_profile="true"><rtps>
                                 <name>from the file</name></rtps></participant>)"));
    ASSERT_TRUE(waitUntil([&] { return station->endpoints().size() == 1; }));
    EXPECT_EQ(station->endpoints()[0].participantName, "from the file");
    EXPECT_TRUE(receives(*station));
}

TEST_F(XmlProfiles, ATopicsQosIsTheUsersByItsRosName) {
    const auto station = nodeIn(m_domain);
    const auto environment = profiles(R"(<data_writer profile_name="/k/odom"><qos>
        <reliability><kind>RELIABLE</kind></reliability><durability><kind>TRANSIENT_LOCAL</kind></durability>
        </qos></data_writer>)");
    const ChildProcess robot(program("dds_peer"), talk(m_domain, {"name=ours", "wait=0"}), environment);
    ASSERT_TRUE(waitUntil([&] { return station->endpoints().size() == 1; }));
    const RemoteEndpoint endpoint = station->endpoints()[0];
    EXPECT_EQ(endpoint.participantName, "ours");
    EXPECT_EQ(endpoint.qos.reliability, Qos::Reliability::Reliable);
    EXPECT_EQ(endpoint.qos.durability, Qos::Durability::TransientLocal);
    EXPECT_TRUE(receives(*station));
}

TEST_F(XmlProfiles, AFileThatIsMissingIsAnError) {
    ChildProcess robot(program("dds_peer"), talk(m_domain, {}),
                       {std::string(detail::fastdds::ProfilesVariable) + "=/nowhere/profiles.xml"});
    EXPECT_EQ(robot.wait(), 1);
    EXPECT_THAT(robot.out(), testing::HasSubstr(std::string(detail::fastdds::ProfilesVariable) +
                                                "=/nowhere/profiles.xml: cannot be"));
}

}  // namespace
}  // namespace leitstand::test
