// Small files that cost seconds or gigabytes when they are decoded are refused before.
#include "core/perception/pictures/coding/picture_cost.h"

#include <algorithm>
#include <chrono>
#include <random>

#include <sys/resource.h>
#include <zlib.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "tests/core/perception/pictures.h"
#include "tests/support/attack.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

std::string bigEndianText(std::uint32_t value) {
    std::string text;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) text += static_cast<char>(value >> shift);
    return text;
}

std::string chunk(const std::string& type, const std::string& content) {
    const std::string body = type + content;
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return bigEndianText(static_cast<std::uint32_t>(content.size())) + body +
           bigEndianText(static_cast<std::uint32_t>(sum));
}

/// @p size zeros, deflated.
std::string zeros(std::size_t size) {
    const std::vector<Bytef> in(size);
    std::vector<Bytef> out(compressBound(size));
    uLongf length = out.size();
    compress2(out.data(), &length, in.data(), size, Z_BEST_COMPRESSION);
    return {reinterpret_cast<const char*>(out.data()), length};
}

/// @p times 4 MB of zeros, deflated, without an end: each block stands for itself, so one is made.
std::string manyZeros(std::size_t times) {
    z_stream stream{};
    deflateInit(&stream, Z_BEST_COMPRESSION);
    std::vector<unsigned char> in(4U << 20U), out(1U << 16U);
    std::string head, block;
    for (std::string* part : {&head, &block}) {
        stream.next_in = in.data();
        stream.avail_in = static_cast<uInt>(in.size());
        stream.next_out = out.data();
        stream.avail_out = static_cast<uInt>(out.size());
        deflate(&stream, Z_FULL_FLUSH);
        part->assign(reinterpret_cast<const char*>(out.data()), out.size() - stream.avail_out);
    }
    deflateEnd(&stream);
    for (std::size_t i = 1; i < times; ++i) head += block;
    return head;
}

PictureSample sampleOf(const std::string& file) {
    const auto* begin = reinterpret_cast<const std::byte*>(file.data());
    return pictureFile({begin, begin + file.size()});
}

/// A PNG of @p chunks between its header and its end.
PictureSample pngOf(std::uint32_t width, std::uint32_t height, char depth, char colour,
                    const std::string& chunks) {
    const std::string header =
        bigEndianText(width) + bigEndianText(height) + depth + colour + std::string(3, '\0');
    return sampleOf("\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunks + chunk("IEND", ""));
}

std::string textOf(const PictureSample& sample) {
    const auto bytes = sample.content.bytes;
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A progressive JPEG of one grey with its last scan @p more times more.
PictureSample withScans(int side, std::size_t more) {
    const cv::Mat mat(side, side, CV_8UC1, cv::Scalar(77));
    std::string file = textOf(pictureFileOf(mat, ".jpg", {cv::IMWRITE_JPEG_PROGRESSIVE, 1}));
    const std::size_t last = file.rfind("\xff\xda"), end = file.rfind("\xff\xd9");
    const std::string scan = file.substr(last, end - last);
    std::string scans;
    for (std::size_t i = 0; i < more; ++i) scans += scan;
    return sampleOf(file.insert(end, scans));
}

double megabytesAtMost() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// What decoding tells, how long it took and how much memory it took more than ever before.
struct Cost {
    std::string error;
    double seconds = 0.0, megabytes = 0.0;
};

Cost costOf(const PictureSample& sample) {
    const double before = megabytesAtMost();
    const auto began = Clock::now();
    Cost cost;
    cost.error = pictureError(sample);
    cost.seconds = std::chrono::duration<double>(Clock::now() - began).count();
    cost.megabytes = megabytesAtMost() - before;
    return cost;
}

void refused(const std::string& what, const PictureSample& sample, const std::string& why) {
    const Cost cost = costOf(sample);
    EXPECT_THAT(cost.error, HasSubstr(why)) << what;
    EXPECT_LT(cost.seconds, 1.0) << what;  // generous: decoding takes more than ten times as long
    EXPECT_LT(cost.megabytes, 100.0) << what;
    tellAttack("pictures", what, 1,
               fmt::format("a file of {:.0f} kB is {} after {:.0f} ms and {:.0f} MB",
                           1e-3 * double(sample.content.bytes.size()),
                           cost.error == "none" ? "decoded without it" : "refused", 1e3 * cost.seconds,
                           cost.megabytes));
}

TEST(PictureCost, AJpegOfThousandsOfScansIsRefused) {
    const PictureSample many = withScans(1'000, 3'000);
    refused("JPEG of 3,000 scans", many, "at most 100 scans");
    EXPECT_EQ(pictureError(withScans(1'000, 20)), "none");
}

TEST(PictureCost, ManyScansOfALargePictureAreRefused) {
    refused("JPEG of 16 megapixels in 60 scans", withScans(4'096, 60), "pixels in all of them");
}

TEST(PictureCost, DataBeyondThePixelsAreRefused) {
    refused("PNG of 64 x 64 pixels with 1 GB of data", pngOf(64, 64, 8, 0, chunk("IDAT", manyZeros(256))),
            "found more");
    // In many small chunks, too.
    std::string parts;
    const std::string data = manyZeros(64);
    for (std::size_t i = 0; i < data.size(); i += 1'000) parts += chunk("IDAT", data.substr(i, 1'000));
    refused("PNG of 64 x 64 pixels with 268 MB of data in chunks", pngOf(64, 64, 8, 0, parts), "found more");
}

TEST(PictureCost, TextsOfAPngAreNotInflated) {
    std::string texts;
    const std::string text = std::string("a\0\0", 3) + zeros(7U << 20U);
    for (int i = 0; i < 140; ++i) texts += chunk("zTXt", text);
    refused("PNG with 140 texts of 7 MB", pngOf(64, 64, 8, 0, texts + chunk("IDAT", zeros(65 * 64))), "none");
}

TEST(PictureCost, APngThatGetsTooLargeIsRefused) {
    refused("PNG of 400 kB, 400 MB when decoded", pngOf(16'384, 3'051, 16, 6, chunk("IDAT", manyZeros(96))),
            "at most 16777216");
    refused("PNG of 16 bits and four channels", pngOf(4'096, 4'096, 16, 6, chunk("IDAT", manyZeros(32))),
            "bytes when it is decoded");
}

TEST(PictureCost, WhatIsRefusedIsNotJudgedByItsNameAlone) {
    // Fewer data than the pixels need, garbage and a chunk without an end are told by the decoder.
    EXPECT_NE(pictureError(pngOf(64, 64, 8, 0, chunk("IDAT", "garbage"))), "none");
    EXPECT_NE(pictureError(pngOf(64, 64, 8, 0, "\x7f\xff\xff\xffIDAT")), "none");
    EXPECT_NE(pictureError(pngOf(64, 64, 8, 0, "")), "none");
    EXPECT_THAT(pictureError(pngOf(64, 64, 8, 5, chunk("IDAT", zeros(65 * 64)))), HasSubstr("known kind"));
    EXPECT_NE(pictureError(pngOf(64, 64, 99, 2, chunk("IDAT", zeros(65 * 64)))), "none");
}

TEST(PictureCost, LargePicturesAndInterlacedOnesAreDecoded) {
    cv::Mat mat(1'500, 2'000, CV_8UC3);
    cv::randu(mat, 0, 255);
    EXPECT_EQ(pictureError(pictureFileOf(mat, ".jpg")), "none");
    EXPECT_EQ(pictureError(pictureFileOf(mat, ".jpg", {cv::IMWRITE_JPEG_PROGRESSIVE, 1})), "none");
    EXPECT_EQ(pictureError(pictureFileOf(mat, ".png", {cv::IMWRITE_PNG_COMPRESSION, 1})), "none");
    // 5 x 3 pixels take six passes: 1 x 1 three times, 3 x 1, 2 x 2 and 5 x 1, with a byte before each row.
    const std::string header = bigEndianText(5) + bigEndianText(3) + std::string("\x08\x00\x00\x00\x01", 5);
    const auto interlaced = [&](std::size_t data) {
        return pictureError(sampleOf("\x89PNG\r\n\x1a\n" + chunk("IHDR", header) +
                                     chunk("IDAT", zeros(data)) + chunk("IEND", "")));
    };
    EXPECT_EQ(interlaced(2 + 2 + 2 + 4 + 2 * 3 + 6), "none");
    EXPECT_THAT(interlaced(23), HasSubstr("found more"));
}

}  // namespace
}  // namespace leitstand::test
