// Messages of types that the station does not know: their publishers are asked.
#include "app/services/topics/type_asker.h"

#include <atomic>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/domain/seen_topics.h"
#include "app/services/topics/topic_watch.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/services/service_server.h"
#include "transport/services/type_description.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

constexpr const char* Type = "rover_msgs/msg/Wheels";
const std::string Hash = "RIHS01_" + std::string(64, 'a');

/// A node "/driver" that publishes wheels, and may tell what they are.
struct Rover {
    explicit Rover(const TestDomain& domain, bool tells) : node(nodeIn(domain)) {
        WriterSettings writer;
        writer.topic = "/wheels";
        writer.type = Type;
        writer.typeHash = Hash;
        wheels = must(node->publisher(writer));
        if (!tells) return;
        server = must(ServiceServer::createRaw(
            *node, "/driver/get_type_description", TypeDescriptionService, [this](const Payload& request) {
                const auto asked = decodeTypeRequest(*request);
                right = asked && asked->type == Type && asked->hash == Hash;
                if (calls++ < missed) return Payload();  // as of a server that has not found its client yet
                return encodeTypeAnswer(MessageText::parse(Type, "float64 speed\nint32[] ticks\n").value());
            }));
    }
    void publish() const {
        CdrWriter out;
        out.write(1.5);
        out.write(std::uint32_t{2});
        out.write(std::int32_t{7});
        out.write(std::int32_t{8});
        (void)wheels->write(std::make_shared<const std::vector<std::byte>>(std::move(out).finish()));
    }
    std::unique_ptr<Node> node;
    std::unique_ptr<Publisher> wheels;
    std::atomic<bool> right = false;
    std::atomic<int> calls = 0, missed = 0;
    std::unique_ptr<ServiceServer> server;
};

/// The topic as it is seen from @p node; @p by: the node that publishes it.
SeenTopic seenFrom(Node& node, const std::string& by) {
    SeenTopic found;
    EXPECT_TRUE(waitUntil([&] {
        for (const SeenTopic& topic : seenTopics(node.endpoints(), {}))
            if (topic.name == "/wheels") found = topic;
        return !found.name.empty();
    }));
    if (!by.empty()) found.nodes = {by};
    return found;
}

TEST(TypeAsker, ShowsMessagesOfATypeThatOnlyTheirPublisherKnows) {
    const TestDomain domain;
    const Rover rover(domain, true);
    const auto node = nodeIn(domain);
    const SeenTopic topic = seenFrom(*node, "/driver");
    EXPECT_EQ(topic.typeHash, Hash);
    TopicWatch watch(*node);
    ASSERT_TRUE(watch.watch(topic));
    std::optional<TopicView> view;
    EXPECT_TRUE(waitUntil([&] {
        rover.publish();
        view = watch.view();
        return view && view->newest;
    })) << (view ? view->problem : "");
    EXPECT_TRUE(rover.right) << "the request names type and hash";
    ASSERT_TRUE(view->newest);
    EXPECT_EQ(numberAt(*view->newest, "speed"), 1.5);
    EXPECT_EQ(view->problem, "");
}

TEST(TypeAsker, AsksAgainWhereTheFirstCallWasMissed) {
    const TestDomain domain;
    Rover rover(domain, true);
    rover.missed = 2;
    const auto node = nodeIn(domain);
    TypeAsker types(*node);
    const SeenTopic topic = seenFrom(*node, "/driver");
    std::optional<Result<MessageTextPtr>> text;
    EXPECT_TRUE(waitUntil([&] {
        text = types.text(topic);
        return text.has_value();
    }));
    ASSERT_TRUE(text && *text) << (text ? text->error().text : "");
    EXPECT_EQ(rover.calls, 3);
}

TEST(TypeAsker, SaysWhyATypeIsNotKnown) {
    const TestDomain domain;
    const Rover rover(domain, false);
    const auto node = nodeIn(domain);
    TypeAsker types(*node);
    const auto nobody = types.text(seenFrom(*node, ""));
    ASSERT_TRUE(nobody);
    EXPECT_THAT(nobody->error().text, HasSubstr("its publisher does not tell it"));
    types.forgetFailures();
    const SeenTopic topic = seenFrom(*node, "/driver");
    EXPECT_FALSE(types.text(topic)) << "asked, without an answer yet";
    std::optional<Result<MessageTextPtr>> silent;
    EXPECT_TRUE(waitUntil([&] {
        silent = types.text(topic);
        return silent.has_value();
    }));
    EXPECT_THAT(silent->error().text, HasSubstr("/driver does not answer"));
}

TEST(TypeAsker, KnowsWhatComesWithTheStationWithoutAsking) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    TypeAsker types(*node);
    SeenTopic topic;
    topic.type = "nav_msgs/msg/Odometry";
    const auto text = types.text(topic);
    ASSERT_TRUE(text && *text);
    EXPECT_EQ(text->value()->type(), "nav_msgs/Odometry");
}

}  // namespace
}  // namespace leitstand::test
