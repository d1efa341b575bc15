#pragma once

#include <memory>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libswscale/swscale.h>
}

namespace leitstand::libav {

struct Free {
    void operator()(AVCodecContext* one) const { avcodec_free_context(&one); }
    void operator()(AVPacket* one) const { av_packet_free(&one); }
    void operator()(AVFrame* one) const { av_frame_free(&one); }
    void operator()(SwsContext* one) const { sws_freeContext(one); }
};

/// Owns what libav made.
template <class Kind>
using Owned = std::unique_ptr<Kind, Free>;

}  // namespace leitstand::libav
