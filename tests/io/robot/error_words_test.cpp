#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/words.h"
#include "core/io/pad/pad_file.h"
#include "core/io/robot/robot_file.h"
#include "core/io/settings/alarm_file.h"
#include "core/io/settings/comparison_file.h"
#include "core/io/settings/layout_file.h"
#include "core/io/settings/score_file.h"
#include "tests/io/robot/robot_texts.h"

namespace leitstand::test {
namespace {

/// A language without words of its own, «{}{}»: English that is left was not translated.
std::string wordless(const char* /*context*/, const char* text) {
    const std::string_view words = text;
    std::string gaps;
    for (auto gap = words.find('{'); gap != std::string_view::npos; gap = words.find('{', gap + 1))
        gaps += words.substr(gap, words.find('}', gap) - gap + 1);
    return "«" + gaps + "»";
}

struct InOtherWords {
    InOtherWords() { setTranslator(&wordless); }
    ~InOtherWords() { setTranslator(nullptr); }
    InOtherWords(const InOtherWords&) = delete;
    InOtherWords& operator=(const InOtherWords&) = delete;
};

/// What @p read says of what is wrong with each of @p texts is all translated.
template <class Read>
void expectTranslated(Read read, const std::vector<std::string>& texts) {
    const InOtherWords language;
    for (const std::string& text : texts) {
        const auto result = read(text);
        ASSERT_FALSE(result.ok()) << text;
        std::string_view left = result.error().text;
        while (!left.empty()) {
            const std::string_view line = left.substr(0, left.find('\n'));
            EXPECT_TRUE(line.find("«") != std::string_view::npos && line.ends_with("»")) << line;
            for (const char* word :
                 {"expected", "found", "nothing", "and values", "a list", " or ", "did you", "only", "under",
                  "missing", "stands", "opened", "errors", "mistake"})
                EXPECT_EQ(line.find(word), std::string_view::npos) << line;
            left.remove_prefix(std::min(left.size(), line.size() + 1));
        }
    }
}

TEST(YamlErrorWords, OfRobotsAreTranslated) {
    std::vector<std::string> texts = {
        "{}",
        "",
        "- 1",
        "letter: k\nname: 3d\nstreams: {role: imu}\n",
        "a: [}",
        std::string("letter: K\nname: \0", 17),
        std::string(300'000, ' '),
        Whole + "---\nletter: K",
        Whole + "a: " + std::string(17, '['),
        Whole + "limits:\n\troll: 20",
    };
    for (const char* line : {"hight: 1",
                             "height: 1\nheight: 2",
                             "? [1]\n: 3",
                             "height: tall",
                             "refine_turns: 1",
                             "drive: wheels",
                             "drive:",
                             "title: []",
                             "title: &a x",
                             "title: !mine x",
                             "a: *b",
                             "frames: {base: /a}",
                             "limits: {spead: 1}",
                             "footprint: 1",
                             "footprint: [1]",
                             "footprint: []",
                             "link_loss: {a: b}",
                             "footprint: [[0, 0], [1, 1], [1, 0], [0, 1]]",
                             "footprint: [[0, 0], [1, 0], [1, 0], [0, 1]]",
                             "footprint: [[0, 0], [0.01, 0], [0, 0.01]]",
                             "link_loss: {teleoperation: return_to_link}",
                             "sensors: {my camera: {}}",
                             "sensors: {imu: {position: [1]}}",
                             "bindings: {forward: W, back: W}"})
        texts.push_back(Whole + line + "\n");
    for (const char* keys :
         {"topic: /a", "role: point", "role: imu, topic: odom", "role: imu, topic: /leitstand/grants",
          "role: imu, type: Imu", "role: picture", "role: picture, sensor: lefd", "role: imu, stamp: zero",
          "role: imu, hardware_id: x", "role: imu, thermal: {}", "role: imu, qos: {depth: 1.5}",
          "role: stop_command, qos: {lifespan: 0.3}", "role: odometry}, {role: odometry"})
        texts.push_back(Head + "sensors: {left: {}}\nstreams: [{" + keys + "}]\n");
    texts.push_back(Head + "streams: [{role: imu, sensor: left}]\n");
    std::string many = Whole + "limits:\n";
    for (int i = 0; i < 150; ++i) many += fmt::format("  key{}: 1\n", i);
    texts.push_back(many);
    expectTranslated([](const std::string& text) { return parseRobot(text, "r.yaml"); }, texts);
    expectTranslated([](const std::string& file) { return readRobot(file); }, {"/nowhere/r.yaml"});
}

TEST(YamlErrorWords, OfLayoutsAreTranslated) {
    expectTranslated(
        [](const std::string& text) { return parseLayout(text, "l.yaml"); },
        {"title: A\n", "panes: {}\n", "panes: {vertical: [{pane: map}]}\n", "panes: {pane: ../map}\n",
         "panes:\n  vertical: [{pane: map}, {pane: map}]\n", "panes: {pane: map}\nkeys: 3\n",
         "panes: {pane: map}\nkeys: {a: [1]}\n", "panes: {pane: map}\nkeys: {a: A, a: B}\n",
         "panes: {pane: map}\narrangement: [1]\n", "panes: {pane: map}\nmap: {look: topp}\n"});
    expectTranslated([](const std::string& file) { return readLayout(file); }, {"/nowhere/l.yaml"});
}

TEST(YamlErrorWords, OfPadsAreTranslated) {
    std::string many = "commands:\n";
    for (int i = 0; i < 65; ++i) many += "  - {command: a, button: 1}\n";
    expectTranslated([](const std::string& text) { return parsePad(text, "p.yaml"); },
                     {"controls: {stop: {}}", "controls: {stop: {button: 1, axis: 2}}",
                      "controls: {turbo: {axis: 1, towards: 0}}", "commands: [{button: 1}]",
                      "commands: [{command: 'rm -rf /', button: 1}]", many});
    expectTranslated([](const std::string& file) { return readPad(file); }, {"/nowhere/p.yaml"});
}

TEST(YamlErrorWords, OfAlarmsScoresAndComparisonsAreTranslated) {
    expectTranslated([](const std::string& text) { return parseAlarmLimits(text, "a.yaml"); },
                     {"co2: much\nattitud: 50\n"});
    expectTranslated([](const std::string& file) { return readAlarmLimits(file); }, {"/"});
    expectTranslated([](const std::string& text) { return parseScoreProfile(text, "s.json"); },
                     {"{}", R"({"victim_tags": [""], "unconfirmed": [[]]})"});
    expectTranslated([](const std::string& file) { return readScoreProfile(file); }, {"/nowhere/s.json"});
    const std::string pose = "[0, 0, 0, 0, 0, 0, 1]", odd = "[0, 0, 0, 0, 0, 0, 2]";
    const std::string scan = fmt::format("{{id: 1, recorded: {}, again: {}, fit_again: [1, 2]}}", pose, odd);
    expectTranslated([](const std::string& text) { return parseComparison(text, "c.yaml"); },
                     {"max_distances: []\nscans: [{}]\n", "max_distances: [-1]\n",
                      "recorded: {truth: [-1, 1, 1], finds: [1, 1, 1, 1, 2]}\n",
                      fmt::format("scans: [{}, {}]\n", scan, scan)});
    expectTranslated([](const std::string& file) { return readComparison(file); }, {"/nowhere/c.yaml"});
}

}  // namespace
}  // namespace leitstand::test
