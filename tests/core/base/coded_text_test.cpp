#include "core/base/phrases/coded_text.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using testing::ElementsAre;
using testing::Pair;

constexpr std::array Known = {
    LogPhrase{"stopped", "stopped by {}", {"who"}},
    LogPhrase{"moved", "moved {} m in {} s", {"metres", "seconds"}},
    LogPhrase{"moved", "moved {} m", {"metres"}},
    LogPhrase{"idle", "does nothing"},
};

TEST(CodedText, ValuesComeBackWhateverIsInThem) {
    for (const std::string value :
         {"12", "", " ", "a b", "\"", "\\", "\\\"", "a=b", "\n", "ä; =\"", "x y=\"z\""}) {
        const std::string text = toString(CodedText{"some_code", {{"first", value}, {"second", "2"}}});
        const auto read = codedText(text);
        ASSERT_TRUE(read) << text;
        EXPECT_EQ(read->code, "some_code");
        EXPECT_THAT(read->values, ElementsAre(Pair("first", value), Pair("second", "2"))) << text;
    }
    EXPECT_EQ(toString(CodedText{"disk_full", {{"mb", "64"}, {"file", "/a b"}}}),
              "disk_full mb=64 file=\"/a b\"");
}

TEST(CodedText, FiguresAreFiniteNumbers) {
    const auto read = codedText("x a=1.5 b=nan c=1e999 d=two e=-3");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->figure("a"), 1.5);
    EXPECT_EQ(read->figure("e"), -3.0);
    for (const char* name : {"b", "c", "d", "z"}) EXPECT_FALSE(read->figure(name)) << name;
}

TEST(CodedText, SentencesAreNone) {
    for (const std::string text :
         {"", " ", "Kurt: stands", "the disk is full", "x  a=1", "x a=1 ", "x a", "x a=", "x =1", "x a=\"1",
          "x a=\"1\"b=2", "x a=\"\\", "X a=1", "x A=1", "x a=b=c", "brake test passed: it stood after 3 ms"})
        EXPECT_FALSE(codedText(text)) << text;
    EXPECT_TRUE(codedText("stopped")) << "a code alone";
    std::string huge = "x a=\"";
    huge.append(2'000'000, '\\');
    EXPECT_FALSE(codedText(huge + "x"));
}

/// The words that @p text was read as; null: none of the known.
const char* wordsIn(std::string_view text) {
    const ReadPhrase read = readPhrase(text, Known);
    return read.phrase ? read.phrase->words : nullptr;
}

TEST(LogPhrases, AreReadByCodeOrByTheSentenceOfOldLogs) {
    EXPECT_EQ(logged(Known[1], 0.5, 3), "moved metres=0.5 seconds=3");
    EXPECT_STREQ(wordsIn("moved metres=0.5 seconds=3"), Known[1].words);
    EXPECT_STREQ(wordsIn("moved metres=0.5"), Known[2].words);
    EXPECT_STREQ(wordsIn("moved 0.5 m in 3 s"), Known[1].words);
    EXPECT_THAT(readPhrase("stopped by Kurt 3D", Known).values, ElementsAre("Kurt 3D"));
    EXPECT_THAT(readPhrase(logged(Known[0], "Kurt 3D"), Known).values, ElementsAre("Kurt 3D"));
    EXPECT_STREQ(wordsIn("does nothing"), Known[3].words);
    EXPECT_STREQ(wordsIn("idle"), Known[3].words);
    for (const char* text : {"", "stopped", "moved", "moved seconds=3", "walked metres=1", "moved by"})
        EXPECT_EQ(wordsIn(text), nullptr) << text;
    EXPECT_EQ(wordsOf("none", readPhrase("moved seconds=3 metres=1", Known)), "moved 1 m in 3 s")
        << "names decide, not their order";
}

TEST(LogPhrases, OutliveTheTableTheyWereReadWith) {
    const ReadPhrase read = readPhrase("idle", std::array{Known[0], Known[3]});
    ASSERT_TRUE(read.phrase);
    EXPECT_EQ(wordsOf("none", read), "does nothing");
}

}  // namespace
}  // namespace leitstand
