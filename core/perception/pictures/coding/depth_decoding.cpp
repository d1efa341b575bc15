#include "core/perception/pictures/coding/depth_decoding.h"

#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/base/words.h"
#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/depth_file.h"
#include "core/perception/pictures/coding/picture_decoding.h"

namespace leitstand {
namespace {

template <class T>
T valueAt(std::span<const std::byte> bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

/// Reads numbers of RVL: 32-bit words, each of eight parts of 4 bits, the highest first. A part holds 3 bits
/// of a number, the lowest first, and whether another part follows.
class RvlReader {
public:
    explicit RvlReader(std::span<const std::byte> bytes) : m_bytes(bytes) {}

    /// Empty at the end, and for numbers that are too large.
    std::optional<std::uint32_t> number() {
        std::uint32_t value = 0;
        for (unsigned shift = 0; shift < 30; shift += 3) {
            if (m_left == 0) {
                if (m_at + sizeof(m_word) > m_bytes.size()) return std::nullopt;
                m_word = valueAt<std::uint32_t>(m_bytes, m_at);
                m_at += sizeof(m_word);
                m_left = 8;
            }
            const std::uint32_t part = m_word >> 28U;
            m_word <<= 4U;
            --m_left;
            value |= (part & 7U) << shift;
            if ((part & 8U) == 0) return value;
        }
        return std::nullopt;
    }

private:
    std::span<const std::byte> m_bytes;
    std::size_t m_at = 0;
    std::uint32_t m_word = 0;
    int m_left = 0;  ///< parts of the word
};

Error damaged() {
    return {translate("leitstand::Error", "picture of depths: its RVL data are damaged")};
}

Result<Picture> decodeRvl(std::span<const std::byte> bytes, const PictureLimits& limits) {
    const std::int64_t width = valueAt<std::int32_t>(bytes, 0), height = valueAt<std::int32_t>(bytes, 4);
    if (width <= 0 || height <= 0 || width > limits.maxSide || height > limits.maxSide ||
        width * height > limits.maxFilePixels)
        return Error{leitstand::fill(
            translate("leitstand::Error", "picture of depths: expected at most {} pixels, found {} x {}"),
            limits.maxFilePixels, width, height)};
    Picture picture{static_cast<int>(width), static_cast<int>(height), Picture::Pixel::Grey16, {}};
    const auto pixels = static_cast<std::size_t>(width * height);
    picture.bytes.resize(pixels * sizeof(std::uint16_t));
    RvlReader in(bytes.subspan(depth_file::RvlHead));
    std::uint16_t last = 0;
    for (std::size_t at = 0; at < pixels;) {
        const auto zeros = in.number();
        if (!zeros || *zeros > pixels - at) return damaged();
        at += *zeros;
        const auto values = in.number();
        if (!values || *values > pixels - at || *zeros + *values == 0) return damaged();
        for (std::uint32_t i = 0; i < *values; ++i, ++at) {
            const auto code = in.number();  // 0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4
            if (!code) return damaged();
            const std::uint32_t half = *code >> 1U;
            last = static_cast<std::uint16_t>(last + ((*code & 1U) != 0 ? ~half : half));
            std::memcpy(picture.bytes.data() + at * sizeof(last), &last, sizeof(last));
        }
    }
    return picture;
}

Result<Picture> decodePng(const PictureSample& sample, std::span<const std::byte> png,
                          const PictureLimits& limits) {
    PictureSample file;
    file.compressed = true;
    file.encoding = "png";
    file.content = {sample.content.owner, png};
    auto picture = decodePicture(file, limits);
    if (picture && picture->pixel != Picture::Pixel::Grey16)
        return Error{translate("leitstand::Error", "picture of depths: expected a PNG of 16 bits")};
    return picture;
}

}  // namespace

Result<Picture> decodeDepthFile(const PictureSample& sample, const PictureLimits& limits) {
    if (auto checked = depth_file::check(sample); !checked) return checked.error();
    const auto bytes = sample.content.bytes;
    const auto content = bytes.subspan(depth_file::Head);
    auto coded =
        depth_file::isRvl(sample.encoding) ? decodeRvl(content, limits) : decodePng(sample, content, limits);
    if (!coded || !sample.encoding.starts_with("32FC1")) return coded;
    const auto a = valueAt<float>(bytes, 4), b = valueAt<float>(bytes, 8);
    Picture depths{coded->width, coded->height, Picture::Pixel::Float32, {}};
    const std::size_t pixels = coded->bytes.size() / sizeof(std::uint16_t);
    depths.bytes.resize(pixels * sizeof(float));
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto value = valueAt<std::uint16_t>(coded->bytes, i * sizeof(std::uint16_t));
        const float depth =
            value == 0 ? std::numeric_limits<float>::quiet_NaN() : a / (static_cast<float>(value) - b);
        std::memcpy(depths.bytes.data() + i * sizeof(float), &depth, sizeof(depth));
    }
    return depths;
}

}  // namespace leitstand
