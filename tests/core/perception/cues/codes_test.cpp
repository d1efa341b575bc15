#include "core/perception/cues/codes.h"

#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/core/perception/cues/cue_pictures.h"
#include "tests/support/missing_tool.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

/// "V-07" as qrencode 4.1.1 draws it (level L).
const std::vector<std::string> Tag = {
    "#######  # ## #######", "#     # ## #  #     #", "# ### # ##  # # ### #", "# ### #  # #  # ### #",
    "# ### # #   # # ### #", "#     # #  ## #     #", "####### # # # #######", "        #####        ",
    "## #  ## ##   ### ## ", "#   #  # #    #  # # ", "#  ######## ##    #  ", "#### # ## ##        #",
    "##   ## ### # # # #  ", "        ####   ## ## ", "####### ##   # # # # ", "#     #   #### ### ##",
    "# ### #  ###  ### ###", "# ### # # ##     ####", "# ### #  ## #   #   #", "#     # # #  ## # # #",
    "####### #####   ###  ",
};

/// The tag with its edge at @p left, @p top, @p module pixels a module, on a wall.
cv::Mat wallWithTag(int left, int top, int module, double turn = 0.0) {
    cv::Mat wall(240, 320, CV_8UC3, cv::Scalar(120, 110, 95));
    const int edge = static_cast<int>(Tag.size()) * module, quiet = 4 * module;
    cv::rectangle(wall, {left - quiet, top - quiet}, {left + edge + quiet, top + edge + quiet},
                  {235, 235, 230}, cv::FILLED);
    for (std::size_t row = 0; row < Tag.size(); ++row) {
        for (std::size_t column = 0; column < Tag[row].size(); ++column) {
            if (Tag[row][column] != '#') continue;
            const int x = left + static_cast<int>(column) * module, y = top + static_cast<int>(row) * module;
            cv::rectangle(wall, {x, y}, {x + module - 1, y + module - 1}, {15, 15, 15}, cv::FILLED);
        }
    }
    if (turn != 0.0) {
        const cv::Mat warp = cv::getRotationMatrix2D({160.0F, 120.0F}, turn, 1.0);
        cv::warpAffine(wall, wall, warp, wall.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    }
    cv::GaussianBlur(wall, wall, {3, 3}, 0.6);
    return noisy(wall, 4.0, 3);
}

TEST(Codes, ATagIsReadAndItsPlaceTold) {
    CodeReader reader;
    const auto found = reader.read(pictureFrom(wallWithTag(100, 80, 3)));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].text, "V-07");
    EXPECT_NEAR(found[0].centre.x(), 100 + 21 * 1.5, 4.0);
    EXPECT_NEAR(found[0].centre.y(), 80 + 21 * 1.5, 4.0);
    EXPECT_NEAR(found[0].size, 63.0, 8.0);
}

TEST(Codes, TurnedGreyAndSmallOnesToo) {
    CodeReader reader;
    EXPECT_EQ(reader.read(pictureFrom(wallWithTag(120, 90, 3, 33.0))).size(), 1U);
    cv::Mat grey;
    cv::cvtColor(wallWithTag(100, 80, 4), grey, cv::COLOR_RGB2GRAY);
    EXPECT_EQ(reader.read(pictureFrom(grey)).size(), 1U);
    EXPECT_EQ(reader.read(pictureFrom(wallWithTag(130, 90, 2))).size(), 1U);
}

TEST(Codes, NothingInNoiseAndStrangePictures) {
    CodeReader reader;
    EXPECT_TRUE(reader.read(pictureFrom(noisy(cv::Mat(240, 320, CV_8UC3, cv::Scalar(127, 127, 127)), 60, 1)))
                    .empty());
    EXPECT_TRUE(reader.read({}).empty());
    EXPECT_TRUE(reader.read({20, 20, Picture::Pixel::Grey16, std::vector<std::byte>(800)}).empty());
    EXPECT_TRUE(reader.read({20, 20, Picture::Pixel::Rgb8, std::vector<std::byte>(11)}).empty());
    EXPECT_TRUE(reader.read({1, 1, Picture::Pixel::Grey8, std::vector<std::byte>(1)}).empty());
}

TEST(Codes, PicturesOfAnotherProgram) {
    const std::filesystem::path writer = "/usr/bin/qrencode";
    if (!std::filesystem::exists(writer)) LEITSTAND_MISSING_TOOL("no qrencode here: needs Debian's package");
    const TemporaryFolder folder;
    CodeReader reader;
    int read = 0, all = 0;
    for (const std::string text : {"V-12", "yellow-3", "https://example.org/robots?run=4&team=leitstand",
                                   "Notausgang 25 m", "0123456789"}) {
        for (const char* level : {"L", "M", "Q", "H"}) {
            const auto file = folder.path() / "code.png";
            const auto written =
                runProcess(writer, {"-l", level, "-s", "3", "-m", "4", "-o", file.string(), text});
            ASSERT_EQ(written.exitCode, 0) << written.err;
            cv::Mat code = cv::imread(file.string(), cv::IMREAD_COLOR);
            ASSERT_FALSE(code.empty());
            cv::Mat wall(std::max(240, code.rows + 20), std::max(320, code.cols + 20), CV_8UC3,
                         cv::Scalar(90, 120, 130));
            code.copyTo(wall(cv::Rect(10, 10, code.cols, code.rows)));
            const auto found = reader.read(pictureFrom(noisy(wall, 5.0, 2)));
            ++all;
            read += found.size() == 1 && found[0].text == text ? 1 : 0;
        }
    }
    std::printf("codes of qrencode: %d of %d read\n", read, all);
    EXPECT_EQ(read, all);
}

}  // namespace
}  // namespace leitstand::test
