#include "core/base/phrases/known_sentence.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/placement/placement_format.h"

namespace leitstand {
namespace {

using testing::ElementsAre;

constexpr std::array<const char*, 4> Known = {"stands", "{} is at {}", "{} m ahead", "by {}"};

TEST(Said, SentencesAreKnownAgainWithTheirValues) {
    EXPECT_STREQ(knownSentence("stands", Known).words, "stands");
    const KnownSentence two = knownSentence("Kurt 3D is at the door", Known);
    EXPECT_STREQ(two.words, "{} is at {}");
    EXPECT_THAT(two.values, ElementsAre("Kurt 3D", "the door"));
    EXPECT_THAT(knownSentence("by ä", Known).values, ElementsAre("ä"));
    EXPECT_THAT(knownSentence("1.20 m ahead", Known).values, ElementsAre("1.20"));
}

TEST(Said, OthersAreNot) {
    for (const std::string logged :
         {"", "stand", "stands!", "by ", " m ahead", " is at the door", "x is at ", "{}"})
        EXPECT_EQ(knownSentence(logged, Known).words, nullptr) << logged;
}

TEST(Said, WhoSpeaksMayGoBefore) {
    EXPECT_STREQ(knownEnding("stands", Known).words, "stands");
    EXPECT_STREQ(knownEnding("Kurt: 3D: stands", Known).words, "stands");
    EXPECT_THAT(knownEnding("by 1: by 2", Known).values, ElementsAre("2")) << "the shortest";
    EXPECT_STREQ(knownEnding(": stands", Known).words, "stands");
    for (const std::string logged : {"", ": ", "stands: ", "Kurt stands", "Kurt:stands", ": : : "})
        EXPECT_EQ(knownEnding(logged, Known).words, nullptr) << logged;
    std::string longest(1'000'000, 'x');
    longest += ": stands";
    EXPECT_EQ(knownEnding(longest, Known).words, nullptr);
}

TEST(Said, FiguresAreReadAsTheyAreSaid) {
    EXPECT_EQ(loggedFigure(12.4), "12");
    EXPECT_EQ(loggedFigure(0.44, 1), "0.4");
    EXPECT_EQ(figureIn("0.4"), 0.4);
    EXPECT_EQ(figureIn("-3"), -3.0);
    for (const std::string logged : {"", "nan", "inf", "-inf", "1e999", "12 s", " 12", "twelve"})
        EXPECT_FALSE(figureIn(logged)) << logged;
}

TEST(Said, ValuesAreFilledInOrder) {
    EXPECT_EQ(withValues("{} ist bei {}", {"Kurt {}", "2"}), "Kurt {} ist bei 2");
    EXPECT_EQ(withValues("{} und {}", {"a"}), "a und {}");
    EXPECT_EQ(withValues("nichts", {"a"}), "nichts");
}

std::string inCapitals(const char* /*context*/, const char* text) {
    std::string capitals = text;
    for (char& letter : capitals)
        letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return capitals;
}

TEST(PlacementSays, SentencesWithinSentencesAreTranslatedToo) {
    setTranslator(&inCapitals);
    using placement_format::inWindowsLanguage;
    EXPECT_EQ(inWindowsLanguage(
                  "found again: 81 % of what it sees is in the map, 12 cm and 3 degrees from the guess"),
              "FOUND AGAIN: 81 % OF WHAT IT SEES IS IN THE MAP, 12 CM AND 3 DEGREES FROM THE GUESS");
    EXPECT_EQ(inWindowsLanguage("put there by the operator, but too little of what it sees is in the map: "
                                "34 % of what it sees is in the map"),
              "PUT THERE BY THE OPERATOR, BUT TOO LITTLE OF WHAT IT SEES IS IN THE MAP: "
              "34 % OF WHAT IT SEES IS IN THE MAP");
    EXPECT_EQ(inWindowsLanguage("Kurt3D sees it: 90 % of what its laser sees there is in the map"),
              "Kurt3D SEES IT: 90 % OF WHAT ITS LASER SEES THERE IS IN THE MAP");
    EXPECT_EQ(inWindowsLanguage("as it was said"), "as it was said");
    for (const LogPhrase& phrase : placement_format::All) {
        const std::string how = withValues(phrase.words, {"1", "2", "3"});
        EXPECT_TRUE(inWindowsLanguage(how) != how || phrase.words == placement_format::Because.words) << how;
    }
    const std::string doubt = logged(placement_format::Because, logged(placement_format::LittleInMap),
                                     logged(placement_format::InMap, 34));
    EXPECT_EQ(logged(placement_format::PutBut, doubt),
              R"(put_but how="because doubt=too_little_in_map why=\"in_map percent=34\"")");
    EXPECT_EQ(inWindowsLanguage(logged(placement_format::PutBut, doubt)),
              "PUT THERE BY THE OPERATOR, BUT TOO LITTLE OF WHAT IT SEES IS IN THE MAP: "
              "34 % OF WHAT IT SEES IS IN THE MAP");
    setTranslator(nullptr);
}

}  // namespace
}  // namespace leitstand
