#include "robots/wire/video_encoder.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

extern "C" {
#include <libavutil/opt.h>
}

#include "core/perception/pictures/video/libav.h"

namespace leitstand {
namespace {

using libav::Owned;

const char* encoderOf(VideoCodec codec) {
    switch (codec) {
        case VideoCodec::H264:
            return "libx264";
        case VideoCodec::H265:
            return "libx265";
    }
    return "";
}

}  // namespace

/// libavcodec's encoder for pictures of one size.
class VideoEncoder::Codec {
public:
    Codec(const VideoEncoding& encoding, const Picture& like)
        : m_width(like.width),
          m_height(like.height),
          m_pixel(like.pixel),
          m_context(contextOf(encoding, like)),
          m_packet(av_packet_alloc()),
          m_frame(av_frame_alloc()),
          m_colours(sws_getContext(like.width, like.height, formatOf(like), like.width, like.height,
                                   AV_PIX_FMT_YUV420P, SWS_BILINEAR, nullptr, nullptr, nullptr)) {
        if (!m_frame) return;
        m_frame->format = AV_PIX_FMT_YUV420P;
        m_frame->width = like.width;
        m_frame->height = like.height;
        if (av_frame_get_buffer(m_frame.get(), 0) != 0) m_frame.reset();
    }

    [[nodiscard]] bool good() const { return m_context && m_packet && m_frame && m_colours; }
    [[nodiscard]] bool fits(const Picture& picture) const {
        return picture.width == m_width && picture.height == m_height && picture.pixel == m_pixel;
    }

    /// Returns no bytes when the encoder failed.
    [[nodiscard]] std::vector<std::byte> encode(const Picture& picture) {
        if (av_frame_make_writable(m_frame.get()) != 0) return {};
        const auto* const rows = reinterpret_cast<const std::uint8_t*>(picture.bytes.data());
        const int stride = picture.width * static_cast<int>(picture.pixelSize());
        sws_scale(m_colours.get(), &rows, &stride, 0, picture.height, m_frame->data, m_frame->linesize);
        m_frame->pts = m_count++;
        if (avcodec_send_frame(m_context.get(), m_frame.get()) != 0) return {};
        std::vector<std::byte> bytes;
        while (avcodec_receive_packet(m_context.get(), m_packet.get()) == 0) {
            const auto* const data = reinterpret_cast<const std::byte*>(m_packet->data);
            bytes.insert(bytes.end(), data, data + m_packet->size);
            av_packet_unref(m_packet.get());
        }
        return bytes;
    }

private:
    static AVPixelFormat formatOf(const Picture& picture) {
        return picture.pixel == Picture::Pixel::Rgb8 ? AV_PIX_FMT_RGB24 : AV_PIX_FMT_GRAY8;
    }
    static Owned<AVCodecContext> contextOf(const VideoEncoding& encoding, const Picture& like) {
        av_log_set_level(AV_LOG_QUIET);
        const AVCodec* const codec = avcodec_find_encoder_by_name(encoderOf(encoding.codec));
        if (codec == nullptr) return nullptr;
        Owned<AVCodecContext> made(avcodec_alloc_context3(codec));
        if (!made) return nullptr;
        made->width = like.width;
        made->height = like.height;
        made->pix_fmt = AV_PIX_FMT_YUV420P;
        made->time_base = {1, std::max(1, static_cast<int>(std::lround(encoding.rate)))};
        made->gop_size = encoding.keyEvery;
        made->max_b_frames = 0;
        made->bit_rate = std::llround(encoding.megabits * 1e6);
        made->thread_count = 1;
        av_opt_set(made->priv_data, "preset", "ultrafast", 0);
        av_opt_set(made->priv_data, "tune", "zerolatency", 0);
        av_opt_set(made->priv_data, "x265-params", "log-level=none", 0);
        return avcodec_open2(made.get(), codec, nullptr) == 0 ? std::move(made) : nullptr;
    }

    int m_width, m_height;
    Picture::Pixel m_pixel;
    Owned<AVCodecContext> m_context;
    Owned<AVPacket> m_packet;
    Owned<AVFrame> m_frame;
    Owned<SwsContext> m_colours;
    std::int64_t m_count = 0;
};

VideoEncoder::VideoEncoder(const VideoEncoding& encoding) : m_encoding(encoding) {}
VideoEncoder::~VideoEncoder() = default;

void VideoEncoder::restart() {
    m_codec.reset();
}

Result<std::vector<std::byte>> VideoEncoder::encode(const Picture& picture) {
    const bool eightBits = picture.pixel == Picture::Pixel::Rgb8 || picture.pixel == Picture::Pixel::Grey8;
    if (!eightBits || picture.width % 2 != 0 || picture.height % 2 != 0)
        return Error{"video: expected pictures of 8 bits with even sizes"};
    if (!m_codec || !m_codec->fits(picture)) m_codec = std::make_unique<Codec>(m_encoding, picture);
    if (!m_codec->good()) {
        m_codec.reset();
        return Error{"video: libavcodec has no such encoder here"};
    }
    std::vector<std::byte> bytes = m_codec->encode(picture);
    if (bytes.empty()) return Error{"video: a picture could not be encoded"};
    return bytes;
}

}  // namespace leitstand
