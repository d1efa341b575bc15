#include "core/perception/pictures/coding/picture_encoding.h"

#include <algorithm>
#include <iterator>

namespace leitstand {
namespace {

using Layout = PictureEncoding::Layout;

// "yuv422" is UYVY for ROS.
constexpr PictureEncoding Encodings[] = {
    {"mono8", Layout::Grey, 1, 1},
    {"8UC1", Layout::Grey, 1, 1},
    {"mono16", Layout::Grey, 2, 2},
    {"16UC1", Layout::Grey, 2, 2},
    {"32FC1", Layout::Float, 4, 4},
    {"rgb8", Layout::Rgb, 3, 1},
    {"bgr8", Layout::Bgr, 3, 1},
    {"8UC3", Layout::Bgr, 3, 1},
    {"rgba8", Layout::Rgba, 4, 1},
    {"bgra8", Layout::Bgra, 4, 1},
    {"8UC4", Layout::Bgra, 4, 1},
    {"yuyv", Layout::Yuyv, 2, 1},
    {"yuv422_yuy2", Layout::Yuyv, 2, 1},
    {"uyvy", Layout::Uyvy, 2, 1},
    {"yuv422", Layout::Uyvy, 2, 1},
    {"bayer_rggb8", Layout::BayerRggb, 1, 1},
    {"bayer_bggr8", Layout::BayerBggr, 1, 1},
    {"bayer_gbrg8", Layout::BayerGbrg, 1, 1},
    {"bayer_grbg8", Layout::BayerGrbg, 1, 1},
};

}  // namespace

const PictureEncoding* findPictureEncoding(std::string_view name) {
    const auto found = std::find_if(std::begin(Encodings), std::end(Encodings),
                                    [&](const PictureEncoding& encoding) { return encoding.name == name; });
    return found == std::end(Encodings) ? nullptr : found;
}

}  // namespace leitstand
