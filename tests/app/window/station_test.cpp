#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QImage>

#include "tests/app/services/scan_folder.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

using test::ProcessOutcome;
using testing::HasSubstr;

/// Runs the station as on a machine without a display, with a configuration of its own.
class StationTest : public testing::Test {
protected:
    [[nodiscard]] ProcessOutcome station(const std::vector<std::string>& arguments) {
        std::vector<std::string> all = {"-u",
                                        "DISPLAY",
                                        "-u",
                                        "WAYLAND_DISPLAY",
                                        "-u",
                                        "QT_QPA_PLATFORM",
                                        "XDG_CONFIG_HOME=" + (m_folder / "config").string()};
        all.insert(all.end(), m_environment.begin(), m_environment.end());
        all.push_back(test::program("leitstand"));
        all.insert(all.end(), arguments.begin(), arguments.end());
        return test::runProcess("/usr/bin/env", all);
    }
    [[nodiscard]] std::string file() const { return (m_folder / "picture.png").string(); }
    [[nodiscard]] QImage picture() const { return QImage(QString::fromStdString(file())); }

    test::TemporaryFolder m_folder;
    std::vector<std::string> m_environment;  ///< "NAME=value"
};

/// How many different colours stand in the map's part of @p picture.
int coloursInTheMap(const QImage& picture) {
    std::set<QRgb> colours;
    for (int y = 100; y < picture.height() - 100; ++y) {
        for (int x = 80; x < picture.width() / 2; ++x) colours.insert(picture.pixel(x, y));
    }
    return static_cast<int>(colours.size());
}

TEST_F(StationTest, AScreenshotNeedsNoDisplayAndShowsTheRegisteredScans) {
    test::writeDrive(m_folder / "room", 2);
    const ProcessOutcome outcome = station({"--screenshot", file(), (m_folder / "room").string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    ASSERT_EQ(picture().size(), QSize(1280, 800));
    EXPECT_GT(coloursInTheMap(picture()), 3);
}

TEST_F(StationTest, SaysThatItRecordsOnlyOnceItDoes) {
    test::writeText(m_folder / "file", "no folder");
    m_environment = {"QT_QPA_PLATFORM=offscreen"};
    const ProcessOutcome outcome = station(
        {"--live", "--interface", "lo", "--mission", (m_folder / "file" / "mission\x1b[2J").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("recorded into")));
    EXPECT_THAT(outcome.err, HasSubstr("mission\\x1b[2J: cannot be made"));
}

TEST_F(StationTest, SizeLookAndThemeOfAScreenshotAreChosen) {
    test::writeDrive(m_folder / "room", 2);
    const std::string room = (m_folder / "room").string();
    const auto outcome =
        station({"--screenshot", file(), "--size", "1000x700", "--look", "top", "--theme", "light", room});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    ASSERT_EQ(picture().size(), QSize(1000, 700));
    EXPECT_GT(picture().pixelColor(4, 4).lightness(), 200);
}

TEST_F(StationTest, TheSizeOfAScreenshotIsInPixelsAtAnyScale) {
    test::writeDrive(m_folder / "room", 2);
    const std::string room = (m_folder / "room").string();
    const auto pictured = [&](const char* scale, std::vector<std::string> arguments) {
        m_environment = {std::string("QT_SCALE_FACTOR=") + scale};
        arguments.insert(arguments.end(), {"--screenshot", file(), room});
        const auto outcome = station(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return picture().size();
    };
    EXPECT_EQ(pictured("2", {"--size", "3840x2160"}), QSize(3840, 2160));
    EXPECT_EQ(pictured("1.5", {"--size", "2401x1501"}), QSize(2401, 1501));
    EXPECT_EQ(pictured("2", {}), QSize(2560, 1600)) << "the usual window";
}

TEST_F(StationTest, ScreenshotsOfTheHallShowIt) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const ProcessOutcome outcome = station({"--screenshot", file(), hall.string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_GT(coloursInTheMap(picture()), 3);
}

TEST_F(StationTest, UnreadableInputFailsWithItsError) {
    test::writeDrive(m_folder / "room", 2);
    test::writeText(m_folder / "room" / "scan001.3d", "1 2 x\n");
    const ProcessOutcome outcome = station({"--screenshot", file(), (m_folder / "room").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("scan001.3d:1"));
    const ProcessOutcome missing = station({"--screenshot", file(), "/nowhere/at-all"});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_THAT(missing.err, HasSubstr("/nowhere/at-all"));
}

TEST_F(StationTest, APictureThatCannotBeWrittenFails) {
    const ProcessOutcome outcome = station({"--screenshot", (m_folder / "missing" / "a.png").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("a.png"));
}

TEST_F(StationTest, WithoutADisplayItOffersTheScreenshot) {
    const ProcessOutcome outcome = station({"room"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("no display"));
    EXPECT_THAT(outcome.err, HasSubstr("--screenshot"));
}

TEST_F(StationTest, WrongUsageExitsWithTwo) {
    EXPECT_EQ(station({"--colour", "blue"}).exitCode, 2);
    EXPECT_EQ(station({"--screenshot", file(), "--look", "sideways"}).exitCode, 2);
    EXPECT_EQ(station({"--screenshot", file(), "--size", "big"}).exitCode, 2);
    EXPECT_EQ(station({"--size", "800x600"}).exitCode, 2);
    EXPECT_EQ(station({"--demo", "--after", "3"}).exitCode, 2) << "of what?";
    EXPECT_THAT(station({"--screenshot", file(), "--after", "3"}).err, HasSubstr("live robots"));
    const auto opened = station({"--screenshot", file(), "--robot", "turtlebot4"});
    EXPECT_EQ(opened.exitCode, 2);
    EXPECT_THAT(opened.err, HasSubstr("--robot is for live robots"));
    EXPECT_THAT(station({"--screenshot", file(), "--size", "9x9"}).err, HasSubstr("WIDTHxHEIGHT"));
}

TEST_F(StationTest, HelpAndVersionAreAnsweredWithoutADisplay) {
    const ProcessOutcome help = station({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.out, HasSubstr("--screenshot"));
    const ProcessOutcome version = station({"--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_THAT(version.out, HasSubstr("leitstand "));
}

}  // namespace
}  // namespace leitstand
