#include "core/messages/message_text.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MessageText parsed(const std::string& type, const std::string& definition) {
    auto text = MessageText::parse(type, definition);
    EXPECT_TRUE(text) << text.error().text;
    return text ? std::move(text).value() : MessageText();
}

std::string errorOf(const std::string& definition) {
    const auto text = MessageText::parse("p/msg/A", definition);
    return text ? std::string("none") : text.error().text;
}

TEST(MessageText, ReadsFieldsWithArraysBoundsDefaultsAndConstants) {
    const MessageText text =
        parsed("p/msg/A",
               "# a comment\n"
               "uint8 LEFT=1\n"
               "string WORD = \"a b\"\n"
               "int32 count 7  # with a default\n"
               "string text \"x=y\"\n"
               "string<=10 short\n"
               "float64[] any\n"
               "float64[<=3] few\n"
               "int8[4] four\n"
               "string<=5[2] words\n"
               "B own\n"
               "std_msgs/Header header\n"
               "===\nMSG: p/B\nbool yes\n"
               "===\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n");
    EXPECT_EQ(text.type(), "p/A");
    EXPECT_THAT(
        text.fields(),
        ElementsAre(MessageField{"int32", "count", false, {}}, MessageField{"string", "text", false, {}},
                    MessageField{"string", "short", false, {}}, MessageField{"float64", "any", true, {}},
                    MessageField{"float64", "few", true, {}}, MessageField{"int8", "four", true, 4},
                    MessageField{"string", "words", true, 2}, MessageField{"p/B", "own", false, {}},
                    MessageField{"std_msgs/Header", "header", false, {}}));
    ASSERT_NE(text.fieldsOf("builtin_interfaces/Time"), nullptr) << "what every writer may leave out";
    EXPECT_EQ(text.fieldsOf("builtin_interfaces/Time")->size(), 2U);
    EXPECT_EQ(text.fieldsOf("p/C"), nullptr);
}

TEST(MessageText, MistakesAreTold) {
    EXPECT_THAT(errorOf("C other\n"), HasSubstr("p/A: its text lacks the type p/C"));
    EXPECT_THAT(errorOf("A again\n"), HasSubstr("lacks the type")) << "a circle";
    EXPECT_THAT(errorOf("int8[x] a\n"), HasSubstr("p/A: expected a type, found \"int8[x]\""));
    EXPECT_THAT(errorOf("int8[99999999999] a\n"), HasSubstr("expected a type"));
    EXPECT_THAT(errorOf("int8[3 a\n"), HasSubstr("expected a type"));
    EXPECT_THAT(errorOf("<=3 a\n"), HasSubstr("expected a type"));
    EXPECT_THAT(errorOf(std::string(MessageText::Longest + 1, 'x')), HasSubstr("expected a text of at most"));
    EXPECT_EQ(errorOf(""), "none");
}

TEST(MessageText, ManyTypesWithinTypesDoNotTakeForEver) {
    std::string text = "T0 a\nT0 b\n";
    for (int i = 0; i < 30; ++i)
        text +=
            "===\nMSG: p/T" + std::to_string(i) + "\n" +
            (i == 29 ? "bool x\n" : "T" + std::to_string(i + 1) + " a\nT" + std::to_string(i + 1) + " b\n");
    EXPECT_EQ(errorOf(text), "none");
}

}  // namespace
}  // namespace leitstand::test
