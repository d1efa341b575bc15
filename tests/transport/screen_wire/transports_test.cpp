#include <mutex>

#include <gmock/gmock.h>

#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"
#include "tests/transport/screen/packets.h"
#include "tests/transport/screen_wire/mutations.h"
#include "tests/transport/screen_wire/one_locator.h"
#include "transport/dds/detail/fastdds.h"
#include "transport/dds/network/screened_transport.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
namespace efd = eprosima::fastdds::dds;
namespace efr = eprosima::fastdds::rtps;
namespace rtps = detail::fastdds::rtps;

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

/// What went out by a way of a transport that sends nothing.
struct SentByWay {
    std::mutex mutex;
    int sent = 0, sentAfterItsEnd = 0;
    bool ended = false;
};
class SilentWay final : public detail::fastdds::WayOut {
public:
    explicit SilentWay(const std::shared_ptr<SentByWay>& sent)
        : WayOut(LOCATOR_KIND_UDPv4,
                 [sent](auto&&...) {
                     const std::scoped_lock lock(sent->mutex);
                     ++(sent->ended ? sent->sentAfterItsEnd : sent->sent);
                     return true;
                 }),
          m_sent(sent) {}
    ~SilentWay() override {
        const std::scoped_lock lock(m_sent->mutex);
        m_sent->ended = true;
    }
    SilentWay(const SilentWay&) = delete;
    SilentWay& operator=(const SilentWay&) = delete;

private:
    std::shared_ptr<SentByWay> m_sent;
};
struct SilentDescriptor final : efr::ChainingTransportDescriptor {
    explicit SilentDescriptor(std::shared_ptr<SentByWay> what)
        : ChainingTransportDescriptor(std::make_shared<efr::UDPv4TransportDescriptor>()),
          sent(std::move(what)) {}
    [[nodiscard]] efr::TransportInterface* create_transport() const override;
    std::shared_ptr<SentByWay> sent;
};
class SilentTransport final : public efr::ChainingTransport {
public:
    explicit SilentTransport(const SilentDescriptor& descriptor)
        : ChainingTransport(descriptor), m_descriptor(descriptor) {}
    efr::TransportDescriptorInterface* get_configuration() override { return &m_descriptor; }
    bool OpenOutputChannel(efr::SendResourceList& ways, const rtps::Locator_t&) override {
        ways.push_back(std::make_unique<SilentWay>(m_descriptor.sent));
        return true;
    }
    bool send(rtps::SenderResource*, detail::fastdds::Outgoing, std::uint32_t, rtps::LocatorsIterator*,
              rtps::LocatorsIterator*, const std::chrono::steady_clock::time_point&) override {
        return false;
    }
    void receive(efr::TransportReceiverInterface*, const rtps::octet*, std::uint32_t, const rtps::Locator_t&,
                 const rtps::Locator_t&) override {}

private:
    SilentDescriptor m_descriptor;
};
efr::TransportInterface* SilentDescriptor::create_transport() const {
    return new SilentTransport(*this);
}

TEST(ScreenedTransports, WhatIsSentAgainGoesOutBeforeItsWayEnds) {
    // A participant that ends lets go of its ways before it shuts its transports down.
    const auto sent = std::make_shared<SentByWay>();
    const auto descriptor = detail::screened(std::make_shared<SilentDescriptor>(sent), detail::screenFor({}));
    const std::unique_ptr<efr::TransportInterface> transport(descriptor->create_transport());
    efr::SendResourceList ways;
    ASSERT_TRUE(transport->OpenOutputChannel(ways, {}));
    ASSERT_EQ(ways.size(), 1U);
    const Bytes announcement = Packet().announce().bytes();
    OneLocator first(7410, false), last(7410, true);
    EXPECT_TRUE(ways.front()->send(detail::fastdds::outgoing(announcement),
                                   static_cast<std::uint32_t>(announcement.size()), &first, &last,
                                   std::chrono::steady_clock::now() + 1s));
    ways.clear();
    transport->shutdown();
    const std::scoped_lock lock(sent->mutex);
    EXPECT_EQ(sent->sent, 3);
    EXPECT_EQ(sent->sentAfterItsEnd, 0);
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
