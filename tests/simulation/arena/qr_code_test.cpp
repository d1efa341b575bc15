#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "robots/simulation/arena/mesh/qr_code.h"
#include "robots/simulation/arena/mesh/sign_pictures.h"
#include "tests/support/missing_tool.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::simulation {
namespace {

std::string rowOf(const QrCode& code, int row) {
    std::string text;
    for (int column = 0; column < code.edge; ++column) text += code.at(row, column) ? '#' : '.';
    return text;
}

TEST(QrCode, GrowsWithItsText) {
    EXPECT_EQ(encodeQr("V-07")->edge, 21);
    EXPECT_EQ(encodeQr(std::string(14, 'a'))->edge, 21);
    EXPECT_EQ(encodeQr(std::string(15, 'a'))->edge, 25);
    EXPECT_EQ(encodeQr(std::string(26, 'a'))->edge, 25);
    EXPECT_EQ(encodeQr(std::string(27, 'a'))->edge, 29);
    EXPECT_EQ(encodeQr(std::string(43, 'a'))->edge, 33);
    EXPECT_EQ(encodeQr(std::string(62, 'a'))->edge, 33);
    EXPECT_FALSE(encodeQr(std::string(63, 'a')));
    EXPECT_TRUE(encodeQr(""));
}

TEST(QrCode, HasItsFinders) {
    const auto code = encodeQr("V-07");
    for (const int row : {0, 6}) EXPECT_EQ(rowOf(*code, row).substr(0, 7), "#######");
    EXPECT_EQ(rowOf(*code, 1).substr(0, 8), "#.....#.");
    EXPECT_EQ(rowOf(*code, 3).substr(13, 8), ".#.###.#");
    EXPECT_EQ(rowOf(*code, 17).substr(0, 8), "#.###.#.");
    EXPECT_EQ(rowOf(*code, 6).substr(6, 9), "#.#.#.#.#");
}

TEST(QrCode, IsReadByAnIndependentDecoder) {
    const std::filesystem::path decoder = "/usr/bin/zbarimg";
    if (!std::filesystem::exists(decoder))
        LEITSTAND_MISSING_TOOL("no zbarimg here: needs Debian's zbar-tools");
    const leitstand::test::TemporaryFolder folder;
    const std::string alphabet = "V-07 yellow/3: Hello, World! 0123456789 abcdefghijklmnopqrstuvwx";
    for (const std::size_t length : {1U, 4U, 14U, 15U, 26U, 27U, 42U, 43U, 61U, 62U}) {
        const std::string text = alphabet.substr(0, length);
        SCOPED_TRACE(text);
        Texture picture = signPicture("qr:" + text);
        const cv::Mat pixels(picture.height, picture.width, CV_8UC3, picture.pixels.data());
        const auto file = folder.path() / "code.png";
        ASSERT_TRUE(cv::imwrite(file.string(), pixels));
        EXPECT_EQ(leitstand::test::runProcess(decoder, {"--quiet", "--raw", file.string()}).out, text + "\n");
    }
}

TEST(SignPictures, AreDifferentAndNotBlank) {
    std::vector<std::vector<std::uint8_t>> all;
    for (const std::string& name : hazardNames()) {
        const Texture picture = signPicture("hazard:" + name);
        EXPECT_GT(picture.width, 100);
        EXPECT_EQ(std::count(all.begin(), all.end(), picture.pixels), 0) << name;
        all.push_back(picture.pixels);
    }
    EXPECT_EQ(signPicture("qr:V-07").width, (21 + 8) * 6);
}

}  // namespace
}  // namespace leitstand::simulation
