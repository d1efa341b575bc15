#include <string>

#include <gtest/gtest.h>

#include "core/io/robot/editing/robot_edits.h"
#include "core/io/robot/robot_file.h"

namespace leitstand::test {
namespace {

const std::string Head = "letter: K\nname: kurt3d\n";
const std::string Tail = "streams: [{role: points, sensor: scanner}]\n";
const ScannerCorrection Correction{-0.0173, degrees(0.25), degrees(-0.1)};

TEST(RobotCorrection, IsWrittenIntoAFileWhoseWordsAndCommentsStay) {
    const std::string text = Head +
                             "# our robot\nsensors:\n    scanner:  # on the mast\n        frame: laser\n" +
                             "        position: [0, 0, 0.5]  # measured\n    imu: {frame: imu}\n" + Tail;
    const auto changed = withCorrection(text, "k.yaml", "scanner", Correction);
    ASSERT_TRUE(changed.ok()) << changed.error().text;
    EXPECT_EQ(*changed, Head +
                            "# our robot\nsensors:\n    scanner:  # on the mast\n"
                            "        correction: {range: -0.0173, roll: 0.250, pitch: -0.100}\n"
                            "        frame: laser\n        position: [0, 0, 0.5]  # measured\n"
                            "    imu: {frame: imu}\n" +
                            Tail);
    const auto again = withCorrection(*changed, "k.yaml", "scanner", {-0.02, 0.0, 0.0});
    ASSERT_TRUE(again.ok()) << again.error().text;
    EXPECT_EQ(again->find("-0.0173"), std::string::npos) << "it takes the place of the one before";
    EXPECT_EQ(parseRobot(*again, "k.yaml")->sensors.at("scanner").correction.range, -0.02);
}

TEST(RobotCorrection, IsWrittenIntoASensorOfOneLine) {
    const std::string begin = Head + "sensors:\n  scanner: {",
                      end = "position: [0, 0, 0.5]}  # on the mast\n" + Tail;
    const auto changed = withCorrection(begin + end, "k.yaml", "scanner", Correction);
    ASSERT_TRUE(changed.ok()) << changed.error().text;
    EXPECT_EQ(*changed, begin + "correction: {range: -0.0173, roll: 0.250, pitch: -0.100}, " + end);
    const auto again = withCorrection(*changed, "k.yaml", "scanner", {-0.02, 0.0, 0.0});
    ASSERT_TRUE(again.ok()) << again.error().text;
    EXPECT_EQ(*again, begin + "correction: {range: -0.0200, roll: 0.000, pitch: 0.000}, " + end);
    const auto bare =
        withCorrection(Head + "sensors: {scanner: {}}\n" + Tail, "k.yaml", "scanner", Correction);
    ASSERT_TRUE(bare.ok()) << bare.error().text;
    EXPECT_NEAR(parseRobot(*bare, "k.yaml")->sensors.at("scanner").correction.range, -0.0173, 1e-12);
}

TEST(RobotCorrection, TellsWhereTheScannerSitsAndHowLateItIsWhereThatIsOff) {
    ScannerCorrection correction = Correction;
    correction.x = 0.0213;
    correction.y = 1e-6;
    correction.yaw = degrees(-0.75);
    correction.clock = -0.06;
    EXPECT_EQ(
        correctionLine(correction),
        "correction: {range: -0.0173, roll: 0.250, pitch: -0.100, x: 0.0213, yaw: -0.750, clock: -0.0600}");
    const auto changed =
        withCorrection(Head + "sensors: {scanner: {}}\n" + Tail, "k.yaml", "scanner", correction);
    ASSERT_TRUE(changed.ok()) << changed.error().text;
    const ScannerCorrection read = parseRobot(*changed, "k.yaml")->sensors.at("scanner").correction;
    EXPECT_EQ(read.x, 0.0213);
    EXPECT_EQ(read.y, 0.0);
    EXPECT_NEAR(read.yaw, degrees(-0.75), 1e-12);
    EXPECT_EQ(read.clock, -0.06);
}

TEST(RobotCorrection, OfAFileThatIsWrittenOtherwiseIsLeftToItsWriter) {
    for (const std::string& sensors :
         {std::string("sensors:\n  other:\n    frame: laser\n"), std::string("sensors:\n  scanner:\n"),
          std::string(""),
          std::string("sensors:\n  scanner:\n    correction:\n      range: 0.1\n    frame: a\n"),
          std::string("sensors: [1, 2]\n"), std::string("sensors: {\n")}) {
        const auto changed = withCorrection(Head + sensors + Tail, "k.yaml", "scanner", Correction);
        ASSERT_FALSE(changed.ok()) << sensors;
        EXPECT_NE(changed.error().text.find("k.yaml: write this below sensors, scanner, by hand: correction: "
                                            "{range: -0.0173, roll: 0.250, pitch: -0.100}"),
                  std::string::npos)
            << changed.error().text;
    }
}

}  // namespace
}  // namespace leitstand::test
