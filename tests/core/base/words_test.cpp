#include "core/base/words.h"

#include <gtest/gtest.h>

namespace leitstand {
namespace {

TEST(Words, AreAsWrittenWithoutAWindow) {
    EXPECT_EQ(translate("anywhere", "{} filed"), "{} filed");
}

TEST(Words, AreOfTheTranslatorAsLongAsThereIsOne) {
    setTranslator([](const char* context, const char* text) { return std::string(context) + "/" + text; });
    EXPECT_EQ(translate("Station", "found"), "Station/found");
    setTranslator(nullptr);
    EXPECT_EQ(translate("Station", "found"), "found");
}

TEST(Words, AreFilledInAndSurviveABadTranslation) {
    EXPECT_EQ(fill("{1} of {0}", 3, "two"), "two of 3");
    EXPECT_EQ(fill("{} und {}", 1), "{} und {}") << "one too many";
    EXPECT_EQ(fill("{", 1), "{");
}

}  // namespace
}  // namespace leitstand
