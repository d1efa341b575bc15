#include "tests/films/film.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

extern "C" {
#include <libavformat/avformat.h>
}

#include "core/perception/pictures/video/libav.h"

namespace leitstand::test {
namespace {

using libav::Owned;

struct CloseInput {
    void operator()(AVFormatContext* one) const { avformat_close_input(&one); }
};

void expect(bool good, const std::filesystem::path& file, const char* what) {
    if (!good) throw std::runtime_error(file.string() + ": " + what);
}

Picture pictureOf(const AVFrame& frame, SwsContext& colours) {
    Picture picture{frame.width, frame.height, Picture::Pixel::Rgb8, {}};
    picture.bytes.resize(std::size_t{3} * static_cast<std::size_t>(frame.width) *
                         static_cast<std::size_t>(frame.height));
    std::uint8_t* const rows[] = {reinterpret_cast<std::uint8_t*>(picture.bytes.data())};
    const int strides[] = {3 * frame.width};
    sws_scale(&colours, frame.data, frame.linesize, 0, frame.height, rows, strides);
    return picture;
}

}  // namespace

void readFilm(const std::filesystem::path& file, const std::function<bool(const Picture&, Time)>& take) {
    AVFormatContext* opened = nullptr;
    expect(avformat_open_input(&opened, file.c_str(), nullptr, nullptr) == 0, file, "cannot be opened");
    const std::unique_ptr<AVFormatContext, CloseInput> format(opened);
    expect(avformat_find_stream_info(format.get(), nullptr) >= 0, file, "has no streams");
    const AVCodec* codec = nullptr;
    const int number = av_find_best_stream(format.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
    expect(number >= 0, file, "has no pictures");
    const AVStream& stream = *format->streams[number];
    const Owned<AVCodecContext> decoder(avcodec_alloc_context3(codec));
    expect(avcodec_parameters_to_context(decoder.get(), stream.codecpar) >= 0 &&
               avcodec_open2(decoder.get(), codec, nullptr) == 0,
           file, "cannot be decoded");
    const Owned<SwsContext> colours(sws_getContext(decoder->width, decoder->height, decoder->pix_fmt,
                                                   decoder->width, decoder->height, AV_PIX_FMT_RGB24,
                                                   SWS_BILINEAR, nullptr, nullptr, nullptr));
    expect(colours != nullptr, file, "has colours that are not known");
    const double rate = av_q2d(stream.avg_frame_rate);
    expect(rate > 0.0, file, "does not say its rate");
    const Owned<AVPacket> packet(av_packet_alloc());
    const Owned<AVFrame> frame(av_frame_alloc());
    for (int count = 0; av_read_frame(format.get(), packet.get()) >= 0; av_packet_unref(packet.get())) {
        if (packet->stream_index != number || avcodec_send_packet(decoder.get(), packet.get()) < 0) continue;
        while (avcodec_receive_frame(decoder.get(), frame.get()) == 0) {
            const std::chrono::duration<double> since(count++ / rate);
            const Time at(std::chrono::duration_cast<std::chrono::nanoseconds>(since));
            if (!take(pictureOf(*frame, *colours), at)) return;
        }
    }
}

}  // namespace leitstand::test
