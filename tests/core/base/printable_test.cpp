#include "core/base/printable.h"

#include <random>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

TEST(Printable, LeavesWordsOfAllLanguagesAlone) {
    const std::string words = "Roboter „Kurt“ – ロボット 🤖 a\\b \"c\" ~";
    EXPECT_EQ(printable(words), words);
    EXPECT_EQ(printableLines("one\ntwo"), "one\ntwo");
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(printable("\x1b]0;title\x07"), "\\x1b]0;title\\x07");
    EXPECT_EQ(printable("\x1b[2J"), "\\x1b[2J");
    EXPECT_EQ(printable("a\nb\rc\td"), "a\\nb\\rc\\td");
    EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
    EXPECT_EQ(printable("\x7f"), "\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\u009b31m")
        << "CSI in one character";
    EXPECT_EQ(printable("kurt\xe2\x80\xae"
                        "gnp"),
              "kurt\\u202egnp")
        << "written backwards";
    EXPECT_EQ(printable("\xe2\x81\xa6"), "\\u2066");
    EXPECT_EQ(printable("\xf3\xa0\x80\x81"), "\\U000e0001");
}

TEST(Printable, ShowsBytesThatAreNoUtf8) {
    EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
    EXPECT_EQ(printable("a\xc3"), "a\\xc3") << "cut off";
    EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b") << "longer than need be";
    EXPECT_EQ(printable("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
    EXPECT_EQ(printable("\xf5\x80\x80\x80"), "\\xf5\\x80\\x80\\x80");
    EXPECT_EQ(printable("\x9b"
                        "31m"),
              "\\x9b31m")
        << "CSI of terminals without UTF-8";
}

TEST(Printable, NothingOfAnyBytesIsObeyed) {
    std::mt19937 random(1);
    for (int round = 0; round < 20'000; ++round) {
        std::string text(random() % 24, '\0');
        for (char& byte : text) byte = static_cast<char>(random());
        const std::string shown = printable(text);
        EXPECT_EQ(printable(shown), shown) << "it is printable, and stays as it is";
        for (const char byte : shown) {
            const auto value = static_cast<unsigned char>(byte);
            ASSERT_TRUE(value >= 0x20 && value != 0x7f) << int(value);
        }
    }
}

TEST(Printable, JsonKeepsItsMeaning) {
    EXPECT_EQ(printableJson("{\"a\": \"\xc2\x9b\x7f\xe2\x80\xae\"}\n"),
              "{\"a\": \"\\u009b\\u007f\\u202e\"}\n");
    EXPECT_EQ(printableJson("\"\xf3\xa0\x80\x81\""), "\"\\udb40\\udc01\"");
    EXPECT_EQ(printableJson("\"ロ\\n\""), "\"ロ\\n\"");
}

}  // namespace
}  // namespace leitstand
