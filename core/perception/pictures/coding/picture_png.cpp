#include "core/perception/pictures/coding/picture_png.h"

#include <cstdint>
#include <cstring>
#include <string_view>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/words.h"

namespace leitstand {
namespace {

constexpr std::size_t HeaderEnd = 8 + 25;  ///< signature and IHDR, which comes first
constexpr std::size_t LongestKeyword = 79;

/// CRC-32 of ISO 3309, as PNG requires it (annex D).
std::uint32_t crc(std::string_view bytes) {
    std::uint32_t value = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        value ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ ((value & 1U) != 0U ? 0xEDB88320U : 0U);
    }
    return ~value;
}

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>((value >> shift) & 0xFFU);
    return bytes;
}

/// A chunk of uncompressed text without language.
std::string textChunk(const std::string& keyword, const std::string& text) {
    std::string body = "iTXt" + keyword.substr(0, LongestKeyword);
    body.append(5, '\0');
    body += text;
    return bigEndian(static_cast<std::uint32_t>(body.size() - 4)) + body + bigEndian(crc(body));
}

}  // namespace

Result<std::vector<std::byte>> encodePng(const Picture& picture, const PictureTexts& texts) {
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (pixels == 0 || picture.bytes.size() != pixels * picture.pixelSize())
        return Error{translate("leitstand::Error", "picture: expected pixels to write, found none")};
    if (picture.pixel == Picture::Pixel::Float32)
        return Error{translate("leitstand::Error",
                               "picture: expected 8 or 16 bits a value, found 32, which PNG does not have")};
    const int type = picture.pixel == Picture::Pixel::Rgb8     ? CV_8UC3
                     : picture.pixel == Picture::Pixel::Grey16 ? CV_16UC1
                                                               : CV_8UC1;
    std::vector<unsigned char> file;
    try {
        cv::Mat mat(picture.height, picture.width, type, const_cast<std::byte*>(picture.bytes.data()));
        if (type == CV_8UC3) {
            cv::Mat turned;
            cv::cvtColor(mat, turned, cv::COLOR_RGB2BGR);
            mat = turned;
        }
        if (!cv::imencode(".png", mat, file) || file.size() < HeaderEnd)
            return Error{translate("leitstand::Error", "picture: it could not be encoded as PNG")};
    } catch (const cv::Exception& error) {
        return Error{leitstand::fill(translate("leitstand::Error", "picture: {}"), error.what())};
    }
    std::string chunks;
    for (const auto& [keyword, text] : texts) {
        if (!keyword.empty()) chunks += textChunk(keyword, text);
    }
    std::vector<std::byte> bytes(file.size() + chunks.size());
    std::memcpy(bytes.data(), file.data(), HeaderEnd);
    if (!chunks.empty()) std::memcpy(bytes.data() + HeaderEnd, chunks.data(), chunks.size());
    std::memcpy(bytes.data() + HeaderEnd + chunks.size(), file.data() + HeaderEnd, file.size() - HeaderEnd);
    return bytes;
}

}  // namespace leitstand
