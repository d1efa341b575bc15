#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace leitstand {

/// An encoding of raw pictures (sensor_msgs/image_encodings.hpp of ROS 2).
struct PictureEncoding {
    enum class Layout : std::uint8_t {
        Grey,
        Rgb,
        Bgr,
        Rgba,
        Bgra,
        Yuyv,
        Uyvy,
        BayerRggb,
        BayerBggr,
        BayerGbrg,
        BayerGrbg,
        Float,
    };
    std::string_view name;         ///< "bgr8"
    Layout layout = Layout::Grey;  ///< order of the colour channels
    std::size_t pixelSize = 1;     ///< bytes per pixel
    std::size_t valueSize = 1;     ///< bytes of one value; the byte order applies to these
};

/// Returns the encoding called @p name; null when Leitstand cannot show it.
[[nodiscard]] const PictureEncoding* findPictureEncoding(std::string_view name);

}  // namespace leitstand
