#include "core/perception/pictures/video/video_decoder.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/words.h"
#include "core/perception/pictures/video/libav.h"
#include "core/perception/pictures/video/video_packet.h"

namespace leitstand {
namespace {

using libav::Owned;

AVCodecID idOf(VideoCodec codec) {
    switch (codec) {
        case VideoCodec::H264:
            return AV_CODEC_ID_H264;
        case VideoCodec::H265:
            return AV_CODEC_ID_HEVC;
    }
    return AV_CODEC_ID_NONE;
}

Error damaged() {
    return {
        translate("leitstand::Error", "picture: of a video, and damaged; waiting for the next key picture")};
}

Error waiting() {
    return {translate("leitstand::Error",
                      "picture: of a video whose last key picture is missing or long ago: the encoder sends "
                      "them too seldom (gop_size), or pictures are lost")};
}

Error tooLarge(std::int64_t most, std::int64_t pixels) {
    return {leitstand::fill(
        translate("leitstand::Error", "picture: of a video, expected at most {} pixels, found {}"), most,
        pixels)};
}

}  // namespace

/// libavcodec's decoder, the picture that it made last, and what converts its colours.
class VideoDecoder::Codec {
public:
    [[nodiscard]] static std::unique_ptr<Codec> create(VideoCodec codec, std::int64_t maxPixels) {
        static std::once_flag silent;
        std::call_once(silent, [] { av_log_set_level(AV_LOG_QUIET); });
        auto made = std::make_unique<Codec>(codec);
        const AVCodec* const found = avcodec_find_decoder(idOf(codec));
        if (found == nullptr) return nullptr;
        made->m_context.reset(avcodec_alloc_context3(found));
        made->m_packet.reset(av_packet_alloc());
        made->m_frame.reset(av_frame_alloc());
        made->m_next.reset(av_frame_alloc());
        if (!made->m_context || !made->m_packet || !made->m_frame || !made->m_next) return nullptr;
        // A picture comes out as soon as it went in; videos of robots have none that need later ones.
        made->m_context->flags |= AV_CODEC_FLAG_LOW_DELAY;
        made->m_context->thread_count = 1;
        // Pictures are decoded in whole blocks, so some pixels are more than what is shown.
        constexpr std::int64_t Blocks = std::int64_t{128} * 128;
        made->m_context->max_pixels = maxPixels + maxPixels / 4 + Blocks;
        return avcodec_open2(made->m_context.get(), found, nullptr) == 0 ? std::move(made) : nullptr;
    }
    explicit Codec(VideoCodec codec) : m_codec(codec) {}

    [[nodiscard]] VideoCodec codec() const { return m_codec; }
    void restart() { avcodec_flush_buffers(m_context.get()); }

    /// Returns false when the packet is damaged, or no picture came of it.
    [[nodiscard]] bool put(const VideoPacket& packet) {
        const auto head = packet.parameters.bytes, body = packet.bytes.bytes;
        // libavcodec reads beyond the end (AV_INPUT_BUFFER_PADDING_SIZE).
        m_padded.assign(head.size() + body.size() + AV_INPUT_BUFFER_PADDING_SIZE, 0);
        if (!head.empty()) std::memcpy(m_padded.data(), head.data(), head.size());
        std::memcpy(m_padded.data() + head.size(), body.data(), body.size());
        m_packet->data = m_padded.data();
        m_packet->size = static_cast<int>(head.size() + body.size());
        bool came = false;
        const bool taken = avcodec_send_packet(m_context.get(), m_packet.get()) == 0;
        while (avcodec_receive_frame(m_context.get(), m_next.get()) == 0) {
            std::swap(m_frame, m_next);
            came = m_frame->decode_error_flags == 0;
        }
        return taken && came;
    }

    /// Number of pixels of the picture that came last.
    [[nodiscard]] std::int64_t pixels() const { return std::int64_t{m_frame->width} * m_frame->height; }

    /// The picture that came last, in colour; empty when its colours are not known.
    [[nodiscard]] std::optional<Picture> picture() {
        const AVFrame& frame = *m_frame;
        m_colours.reset(sws_getCachedContext(
            m_colours.release(), frame.width, frame.height, static_cast<AVPixelFormat>(frame.format),
            frame.width, frame.height, AV_PIX_FMT_RGB24, SWS_POINT, nullptr, nullptr, nullptr));
        if (!m_colours) return std::nullopt;
        const int* const coefficients =
            sws_getCoefficients(frame.colorspace == AVCOL_SPC_BT709 ? SWS_CS_ITU709 : SWS_CS_DEFAULT);
        const int fullRange = frame.color_range == AVCOL_RANGE_JPEG ? 1 : 0;
        sws_setColorspaceDetails(m_colours.get(), coefficients, fullRange, coefficients, 1, 0, 1 << 16,
                                 1 << 16);
        // libswscale writes whole blocks of pixels, and leaves out the last ones of rows without room for
        // that.
        constexpr std::size_t Block = 64;
        const std::size_t row = std::size_t{3} * static_cast<std::size_t>(frame.width);
        const std::size_t stride = (row + 2 * Block) / Block * Block;
        const auto height = static_cast<std::size_t>(frame.height);
        m_rows.resize(stride * height);
        std::uint8_t* const rows[] = {m_rows.data()};
        const int strides[] = {static_cast<int>(stride)};
        if (sws_scale(m_colours.get(), frame.data, frame.linesize, 0, frame.height, rows, strides) !=
            frame.height) {
            return std::nullopt;
        }
        Picture picture{frame.width, frame.height, Picture::Pixel::Rgb8, {}};
        picture.bytes.resize(row * height);
        for (std::size_t y = 0; y < height; ++y)
            std::memcpy(picture.bytes.data() + y * row, m_rows.data() + y * stride, row);
        return picture;
    }

private:
    VideoCodec m_codec;
    Owned<AVCodecContext> m_context;
    Owned<AVPacket> m_packet;
    Owned<AVFrame> m_frame, m_next;
    Owned<SwsContext> m_colours;
    std::vector<std::uint8_t> m_padded, m_rows;
};

VideoDecoder::VideoDecoder(std::int64_t maxPixels) : m_maxPixels(maxPixels) {}
VideoDecoder::~VideoDecoder() = default;
VideoDecoder::VideoDecoder(VideoDecoder&&) noexcept = default;
VideoDecoder& VideoDecoder::operator=(VideoDecoder&&) noexcept = default;

Result<Picture> VideoDecoder::decode(const std::shared_ptr<const VideoPacket>& packet,
                                     const std::stop_token& stop) {
    if (!packet->decodable()) return waiting();
    std::vector<const VideoPacket*> due;
    const VideoPacket* at = packet.get();
    for (; at != m_last.get(); at = at->before.get()) {
        due.push_back(at);
        if (at->key) break;
    }
    if (!m_codec || m_codec->codec() != packet->codec) {
        m_codec = Codec::create(packet->codec, m_maxPixels);
        if (!m_codec)
            return Error{
                translate("leitstand::Error", "picture: of a video that libavcodec does not decode here")};
    }
    if (!due.empty() && due.back()->key) {
        m_codec->restart();
        m_outcome = {};
    }
    m_last = packet;
    std::reverse(due.begin(), due.end());
    for (const VideoPacket* const one : due) {
        if (!m_outcome) break;
        if (stop.stop_requested() || !m_codec->put(*one)) m_outcome = damaged();
    }
    if (m_outcome && m_codec->pixels() > m_maxPixels) m_outcome = tooLarge(m_maxPixels, m_codec->pixels());
    if (!m_outcome) return m_outcome.error();
    auto picture = m_codec->picture();
    return picture ? Result<Picture>(*std::move(picture)) : damaged();
}

}  // namespace leitstand
