// What nodes tell about the types that they use.
#include "transport/services/type_description.h"

#include <chrono>
#include <memory>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transport/cdr/cdr_writer.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

constexpr const char* Type = "rover_msgs/msg/Wheels";
constexpr const char* Definition =
    "std_msgs/Header header\n"
    "int16[4] current_ma\n"
    "float32[] slips\n"
    "bool enabled\n"
    "string name\n"
    "Motor[] motors\n"
    "================\n"
    "MSG: std_msgs/Header\n"
    "builtin_interfaces/Time stamp\n"
    "string frame_id\n"
    "================\n"
    "MSG: builtin_interfaces/Time\n"
    "int32 sec\nuint32 nanosec\n"
    "================\n"
    "MSG: rover_msgs/Motor\n"
    "float64 speed\nuint8 state\n";

MessageText wheels() {
    return MessageText::parse(Type, Definition).value();
}

TEST(TypeDescription, ATypeComesBackAsItWas) {
    const MessageText text = wheels();
    const auto back = decodeTypeAnswer(*encodeTypeAnswer(text), Type);
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(back->type(), text.type());
    EXPECT_EQ(back->types(), text.types());
}

TEST(TypeDescription, TheRequestNamesTypeAndHash) {
    const auto back = decodeTypeRequest(*encodeTypeRequest({Type, "RIHS01_ab"}));
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(back->type, Type);
    EXPECT_EQ(back->hash, "RIHS01_ab");
}

/// A type with one field of @p kind, as type_description_interfaces/msg/Field numbers them.
Payload withField(std::uint8_t kind, const std::string& name, const std::string& nested = {}) {
    CdrWriter out;
    out.write(true);
    out.write(std::string());
    out.write(std::string(Type));
    out.write(std::uint32_t{1});
    out.write(name);
    out.write(kind);
    out.write(std::uint64_t{3});
    out.write(std::uint64_t{0});
    out.write(nested);
    out.write(std::string("7"));
    for (int i = 0; i < 3; ++i) out.write(std::uint32_t{0});
    return std::make_shared<const std::vector<std::byte>>(std::move(out).finish());
}

TEST(TypeDescription, KindsAreThoseOfTheStandard) {
    const std::pair<std::uint8_t, const char*> kinds[] = {{2, "int8"},     {3, "uint8"},    {9, "uint64"},
                                                          {10, "float32"}, {11, "float64"}, {15, "bool"},
                                                          {17, "string"},  {21, "string"}};
    for (const auto& [kind, type] : kinds) {
        const auto read = decodeTypeAnswer(*withField(kind, "a"), Type);
        ASSERT_TRUE(read) << int(kind) << ": " << read.error().text;
        EXPECT_EQ(read->fields().at(0).type, type);
        EXPECT_FALSE(read->fields().at(0).array);
    }
    EXPECT_EQ(decodeTypeAnswer(*withField(48 + 2, "a"), Type)->fields().at(0).count, 3U);
    for (const int sequence : {96 + 2, 144 + 2}) {
        const auto read = decodeTypeAnswer(*withField(static_cast<std::uint8_t>(sequence), "a"), Type);
        EXPECT_TRUE(read->fields().at(0).array);
        EXPECT_FALSE(read->fields().at(0).count);
    }
}

TEST(TypeDescription, WhatMakesNoSenseIsRefused) {
    EXPECT_THAT(decodeTypeAnswer(*encodeTypeAnswer(wheels(), "no such hash"), Type).error().text,
                HasSubstr("no such hash"));
    EXPECT_THAT(decodeTypeAnswer(*encodeTypeAnswer(wheels()), "rover_msgs/msg/Arm").error().text,
                HasSubstr("expected rover_msgs/msg/Arm"));
    for (const int kind : {0, 12, 14, 22, 200, 255})
        EXPECT_FALSE(decodeTypeAnswer(*withField(static_cast<std::uint8_t>(kind), "a"), Type)) << kind;
    EXPECT_FALSE(decodeTypeAnswer(*withField(1, "a", "rover_msgs/msg/None"), Type))
        << "a type that is missing";
    EXPECT_FALSE(decodeTypeAnswer(*withField(1, "a", Type), Type)) << "a type in itself";
    EXPECT_FALSE(decodeTypeAnswer(*withField(2, "a b\nint8 c", ""), Type)) << "two fields as one";
}

TEST(TypeDescription, AnyBytesAreSafe) {
    const auto whole = *encodeTypeAnswer(wheels());
    for (std::size_t size = 0; size < whole.size(); ++size)
        (void)decodeTypeAnswer(std::span(whole).first(size), Type);
    std::mt19937 random(7);
    for (int i = 0; i < 5'000; ++i) {
        auto broken = whole;
        for (int k = 0; k < 3; ++k) broken[random() % broken.size()] = static_cast<std::byte>(random());
        (void)decodeTypeAnswer(broken, Type);
    }
}

}  // namespace
}  // namespace leitstand::test
