#include "core/io/pad/pad_file.h"

#include <random>

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

PadBindings unusual() {
    PadBindings bindings = defaultBindings(PadLayout::Plain);
    EXPECT_TRUE(bindPad(bindings, PadAction::DeadMan, padButton(7)));
    EXPECT_TRUE(bindPad(bindings, PadAction::Forward, padAxis(2, 1, -1.0)));
    EXPECT_TRUE(bindPad(bindings, PadAction::TurnLeft, padAxis(0, -1)));
    EXPECT_TRUE(bindPad(bindings, PadAction::Stop, padButton(127)));
    EXPECT_TRUE(bindPad(bindings, "view.look-2", padAxis(5, -1, 0.25)));
    bindings.deadZone = 0.3;
    bindings.expo = 0.0;
    bindings.press = 0.9;
    bindings.cameraRate = 0.1;
    return bindings;
}

TEST(PadFile, WhatIsWrittenReadsBack) {
    for (const PadBindings& bindings : {defaultBindings(PadLayout::Standard), unusual(), PadBindings{}}) {
        const auto again = parsePad(padText(bindings, "Pad \"X\": # 3"), "pad.yaml");
        ASSERT_TRUE(again.ok()) << again.error().text << "\n" << padText(bindings, "X");
        EXPECT_EQ(*again, bindings);
    }
}

TEST(PadFile, IsWrittenWholeIntoANewFolder) {
    const TemporaryFolder folder;
    const auto file = folder / "pads/0300abcd.yaml";
    ASSERT_TRUE(writePad(unusual(), "Joy\x01stick \xff", file).ok());
    const auto again = readPad(file);
    ASSERT_TRUE(again.ok()) << again.error().text;
    EXPECT_EQ(*again, unusual());
    EXPECT_THAT(readPad(folder / "none.yaml").error().text, HasSubstr("none.yaml"));
    EXPECT_FALSE(writePad(unusual(), "", "/proc/nowhere/pad.yaml").ok());
}

TEST(PadFile, SaysWhatIsWrongAndWhere) {
    const std::pair<const char*, const char*> cases[] = {
        {"", "found nothing"},
        {"[]", "expected keys and values"},
        {"layout: round", "standard or plain"},
        {"dead_zone: 0.9", "dead_zone: expected a number from 0 to 0.6"},
        {"dead_zone: .nan", "dead_zone"},
        {"press: 0", "press"},
        {"expo: 2", "expo"},
        {"camera_rate: -1", "camera_rate"},
        {"dead_zome: 0.1", "did you mean dead_zone?"},
        {"controls: 5", "controls"},
        {"controls: {fly: {button: 1}}", "dead_man"},
        {"controls: {stop: {}}", "found neither"},
        {"controls: {stop: {button: 1, axis: 2}}", "found both"},
        {"controls: {stop: {button: -1}}", "button"},
        {"controls: {stop: {button: 128}}", "button"},
        {"controls: {stop: {button: 1e99}}", "button"},
        {"controls: {stop: {button: 1}, stop: {button: 2}}", "again"},
        {"controls: {turbo: {axis: 1, towards: 0}}", "towards"},
        {"controls: {turbo: {axis: 1, towards: 1, rest: 1}}", "towards"},
        {"controls: {turbo: {axis: 1, rest: 3}}", "rest"},
        {"commands: {}", "expected a list"},
        {"commands: [{button: 1}]", "found nothing"},
        {"commands: [{command: 'rm -rf /', button: 1}]", "camera.recentre"},
        {"commands: [5]", "expected keys and values"},
        {"pad: &x a", "anchor"},
        {"pad: !!binary aGFsbG8=", "tag"},
    };
    for (const auto& [text, expected] : cases) {
        const auto read = parsePad(text, "pad.yaml");
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_THAT(read.error().text, HasSubstr(expected)) << text;
        EXPECT_THAT(read.error().text, HasSubstr("pad.yaml")) << text;
    }
    std::string many = "commands:\n";
    for (int i = 0; i < 65; ++i) many += "  - {command: a, button: 1}\n";
    EXPECT_THAT(parsePad(many, "pad.yaml").error().text, HasSubstr("at most 64"));
}

TEST(PadFile, BytesThatAreTurnedOverNeverBreakIt) {
    const std::string whole = padText(unusual(), "X");
    std::mt19937 random(5);
    for (int round = 0; round < 3'000; ++round) {
        std::string text = whole.substr(0, random() % (whole.size() + 1));
        for (int i = 0; i < 3 && !text.empty(); ++i)
            text[random() % text.size()] = static_cast<char>(random());
        if (const auto read = parsePad(text, "pad.yaml"); read.ok()) {
            EXPECT_LE(read->deadZone, PadBindings::MostDeadZone);
            EXPECT_LE(read->commands.size(), PadBindings::MostCommands);
        } else {
            EXPECT_FALSE(read.error().text.empty());
        }
    }
}

}  // namespace
}  // namespace leitstand::test
