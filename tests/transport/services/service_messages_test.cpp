#include <limits>

#include <gmock/gmock.h>

#include "tests/transport/dds/test_node.h"
#include "transport/services/service_messages.h"

namespace leitstand::test {
namespace {

using Bytes = std::vector<std::byte>;

Payload bytesOf(std::initializer_list<int> values) {
    auto bytes = std::make_shared<Bytes>();
    for (const int value : values) bytes->push_back(static_cast<std::byte>(value));
    return bytes;
}

TEST(ServiceNames, AreThoseOfRos2) {
    const ServiceTopics topics = topicsOf("/tb1/e_stop", "std_srvs/srv/SetBool");
    EXPECT_EQ(topics.request, "rq/tb1/e_stopRequest");
    EXPECT_EQ(topics.answer, "rr/tb1/e_stopReply");
    EXPECT_EQ(topics.requestType, "std_srvs/srv/SetBool_Request");
    EXPECT_EQ(topics.answerType, "std_srvs/srv/SetBool_Response");
    EXPECT_EQ(serviceOf(topics.request), "/tb1/e_stop");
    EXPECT_EQ(serviceTypeOf(topics.requestType), "std_srvs/srv/SetBool");
    for (const char* other : {"rt/scan", "rr/tb1/e_stopReply", "rq/Request", "rq/", "", "rq/tb1/e_stop"})
        EXPECT_EQ(serviceOf(other), "") << other;
    EXPECT_EQ(serviceTypeOf("std_msgs/msg/Bool"), "");
}

TEST(ServiceMessages, AreLaidOutAsRos2LaysThemOut) {
    EXPECT_EQ(*encodeRequest(ServiceKind::Switch, {true}), *bytesOf({0, 1, 0, 0, 1}));
    EXPECT_EQ(*encodeRequest(ServiceKind::Trigger, {}), *bytesOf({0, 1, 0, 0, 0}));
    EXPECT_EQ(encodeRequest(ServiceKind::CancelGoal, {})->size(), 4U + 16U + 8U);
    EXPECT_EQ(*encodeAnswer(ServiceKind::Switch, {true, "on"}),
              *bytesOf({0, 1, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 'o', 'n', 0}));
    EXPECT_EQ(*encodeAnswer(ServiceKind::CancelGoal, {true, ""}),
              *bytesOf({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(ServiceMessages, AreReadAsTheyWereWritten) {
    for (const ServiceFacts& facts : serviceTable()) {
        for (const bool value : {false, true}) {
            const auto request = decodeRequest(facts.kind, *encodeRequest(facts.kind, {value}));
            ASSERT_TRUE(request) << facts.type << ": " << request.error().text;
            EXPECT_EQ(request->value, facts.kind == ServiceKind::Switch && value) << facts.type;
            const auto answer = decodeAnswer(facts.kind, *encodeAnswer(facts.kind, {value, "why"}));
            ASSERT_TRUE(answer) << facts.type << ": " << answer.error().text;
            EXPECT_EQ(answer->accepted, value) << facts.type;
            const bool ofGoals = facts.kind == ServiceKind::CancelGoal || facts.kind == ServiceKind::Navigate;
            EXPECT_EQ(answer->message, ofGoals ? "" : "why") << facts.type;
        }
    }
}

TEST(ServiceMessages, OfGoalsThatAreCancelledAreRead) {
    Bytes bytes(4 + 8 + 2 * 24);
    bytes[1] = std::byte{1};
    bytes[8] = std::byte{2};  // two goals
    const auto answer = decodeAnswer(ServiceKind::CancelGoal, bytes);
    ASSERT_TRUE(answer) << answer.error().text;
    EXPECT_TRUE(answer->accepted);
    bytes[4] = std::byte{1};  // ERROR_REJECTED
    EXPECT_FALSE(decodeAnswer(ServiceKind::CancelGoal, bytes)->accepted);
}

TEST(ServiceMessages, HostileOnesAreRefusedOrTamed) {
    for (const ServiceFacts& facts : serviceTable()) {
        const Bytes whole = *encodeAnswer(facts.kind, {true, "a message"});
        for (std::size_t size = 0; size < whole.size(); ++size)
            EXPECT_FALSE(decodeAnswer(facts.kind, std::span(whole).first(size))) << facts.type << size;
    }
    Bytes huge = *encodeAnswer(ServiceKind::CancelGoal, {true, ""});
    for (std::size_t i = 8; i < 12; ++i) huge[i] = std::byte{0xff};  // 4 billion goals
    EXPECT_FALSE(decodeAnswer(ServiceKind::CancelGoal, huge));
    const auto rude =
        decodeAnswer(ServiceKind::Switch,
                     *encodeAnswer(ServiceKind::Switch, {false, "\x1b[2J" + std::string(5'000, 'x')}));
    ASSERT_TRUE(rude) << rude.error().text;
    EXPECT_LT(rude->message.size(), 300U);
    EXPECT_THAT(rude->message, testing::Not(testing::HasSubstr("\x1b")));
}

TEST(ServiceMessages, AHeaderStandsBeforeTheFields) {
    const Payload body = encodeAnswer(ServiceKind::Switch, {true, "on"});
    const CallHeader header{0x0123456789abcdefU, -2};
    const Payload headed = withHeader(header, body);
    EXPECT_EQ(headed->size(), body->size() + 16);
    EXPECT_EQ((*headed)[4], std::byte{0xef});
    const auto split = splitHeader(*headed);
    ASSERT_TRUE(split);
    EXPECT_EQ(split->header, header);
    EXPECT_EQ(*split->body, *body);
    for (std::size_t size = 0; size < 20; ++size) EXPECT_FALSE(splitHeader(std::span(*headed).first(size)));
}

TEST(ServiceDescriptions, SayWhatAStopAsks) {
    ServiceDescription service{.name = "/e_stop", .type = "std_srvs/srv/SetBool", .stop = true};
    EXPECT_EQ(stopRequest(service), ServiceRequest{true});
    EXPECT_EQ(releaseRequest(service), ServiceRequest{false});
    service.stop = false;  // "enable motors"
    EXPECT_EQ(stopRequest(service), ServiceRequest{false});
    EXPECT_EQ(releaseRequest(service), ServiceRequest{true});
    service.stop.reset();
    EXPECT_FALSE(stopRequest(service) || releaseRequest(service));
    service = {.name = "/halt", .type = "std_srvs/srv/Trigger", .stop = true};
    EXPECT_TRUE(stopRequest(service));
    EXPECT_FALSE(releaseRequest(service));
    service.stop = false;
    EXPECT_FALSE(stopRequest(service));
    EXPECT_TRUE(releaseRequest(service));
    service = {.name = "/navigate_to_pose", .type = "nav2_msgs/action/NavigateToPose"};
    EXPECT_TRUE(stopRequest(service)) << "unless its file says otherwise";
    EXPECT_FALSE(releaseRequest(service));
    service.stop = false;
    EXPECT_FALSE(stopRequest(service));
    EXPECT_FALSE(stopRequest({.name = "/x", .type = "std_srvs/srv/Empty", .stop = true}));
}

}  // namespace
}  // namespace leitstand::test
