#include <gmock/gmock.h>

#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"
#include "tests/transport/screen/packets.h"
#include "tests/transport/screen_wire/mutations.h"
#include "transport/dds/detail/fastdds.h"
#include "transport/dds/network/screened_transport.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
namespace efd = eprosima::fastdds::dds;
namespace efr = eprosima::fastdds::rtps;

bool isScreened(const std::shared_ptr<efr::TransportDescriptorInterface>& transport) {
    return std::dynamic_pointer_cast<efr::ChainingTransportDescriptor>(transport) != nullptr;
}

TEST(ScreenedTransports, WhatTheLibraryTakesByItselfIsScreenedAndSharedMemoryIsTold) {
    efd::DomainParticipantQos qos;  // as of a profile file that says nothing of transports
    const auto warnings = detail::putBefore(qos, detail::screenFor({}));
    EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("shared memory is not screened")));
    EXPECT_FALSE(qos.transport().use_builtin_transports);
    ASSERT_EQ(qos.transport().user_transports.size(), 2U);
    EXPECT_TRUE(isScreened(qos.transport().user_transports[0]));
    EXPECT_FALSE(isScreened(qos.transport().user_transports[1]));
}

TEST(ScreenedTransports, ThoseOfAProfileFileAreScreenedAndTcpIsTold) {
    efd::DomainParticipantQos qos;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports = {std::make_shared<efr::UDPv4TransportDescriptor>(),
                                       std::make_shared<efr::TCPv4TransportDescriptor>()};
    const auto warnings = detail::putBefore(qos, detail::screenFor({}));
    EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("TCP is not screened")));
    EXPECT_TRUE(isScreened(qos.transport().user_transports[0]));
    EXPECT_FALSE(isScreened(qos.transport().user_transports[1]));
}

TEST(ScreenedTransports, ARobotWithAProfileFileWithstands) {
    const TestDomain domain;
    const TemporaryFolder folder;
    writeText(folder / "profiles.xml",
              std::string(R"(<?xml version="1.0" encoding="UTF-8"?><profiles xmlns=")") +
                  detail::fastdds::ProfilesNamespace +
                  R"("><participant profile_name="mine" is_default_profile="true">
<rtps><name>from the file</name></rtps></participant></profiles>)");
    const ChildProcess robot(
        program("dds_peer"), {"talk", std::to_string(domain.number()), "/k/odom", "reliable=0"},
        {std::string(detail::fastdds::ProfilesVariable) + "=" + (folder / "profiles.xml").string()});
    const auto station = nodeIn(domain);
    Inbox inbox;
    const auto listening = must(station->subscribe({"/k/odom", TestType, bestEffort()}, inbox.callback()));
    ASSERT_TRUE(inbox.waitFor(3)) << robot.out();
    Attacker attacker(domain.number());
    for (int i = 0; i < 2 * 17; ++i) attacker.send(Packet().submessage(0x80, 0, Bytes(60), 56).bytes());
    ASSERT_TRUE(waitUntil([&] { return !station->dropped().empty(); }));
    EXPECT_TRUE(inbox.waitFor(inbox.size() + 100, 10s)) << robot.out();
}

}  // namespace
}  // namespace leitstand::test
