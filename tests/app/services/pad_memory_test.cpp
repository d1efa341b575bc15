#include "app/services/pad/pad_memory.h"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

PadBindings changed() {
    PadBindings bindings = defaultBindings(PadLayout::Standard);
    bindings.deadZone = 0.25;
    return bindings;
}

TEST(PadMemory, EveryKindOfPadHasItsOwn) {
    const TemporaryFolder folder;
    const PadMemory memory(folder / "pads");
    std::string warning;
    EXPECT_EQ(memory.bindings("0300abcd", PadLayout::Standard, warning),
              defaultBindings(PadLayout::Standard));
    ASSERT_TRUE(memory.keep("0300abcd", "Pad", changed()).ok());
    EXPECT_EQ(PadMemory(folder / "pads").bindings("0300abcd", PadLayout::Standard, warning), changed());
    EXPECT_EQ(memory.bindings("0500", PadLayout::Standard, warning), defaultBindings(PadLayout::Standard));
    EXPECT_EQ(memory.bindings("0300abcd", PadLayout::Plain, warning), defaultBindings(PadLayout::Plain))
        << "its controls are numbered otherwise";
    EXPECT_EQ(warning, "");
}

TEST(PadMemory, ADamagedFileIsToldAndNotUsed) {
    const TemporaryFolder folder;
    writeText(folder / "0300.yaml", "controls: {stop: }");
    std::string warning;
    EXPECT_EQ(PadMemory(folder.path()).bindings("0300", PadLayout::Standard, warning),
              defaultBindings(PadLayout::Standard));
    EXPECT_THAT(warning, testing::HasSubstr("0300.yaml"));
}

TEST(PadMemory, AGuidIsNoPath) {
    const TemporaryFolder folder;
    const PadMemory memory(folder / "pads");
    ASSERT_TRUE(memory.keep("../../evil", "Pad", changed()).ok());
    EXPECT_TRUE(std::filesystem::exists(folder / "pads/evil.yaml"));
}

}  // namespace
}  // namespace leitstand::test
