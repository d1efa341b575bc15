#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/shared_bytes.h"
#include "core/event/sample_header.h"

namespace leitstand {

/// A picture as it was sent, not decoded; its bytes are those of the message, never copied.
struct PictureSample {
    SampleHeader header;
    bool compressed = false;    ///< whether bytes are a JPEG or PNG file
    std::string encoding;       ///< ROS name, "bgr8", "16UC1"; compressed: the format as sent, "jpeg"
    int width = 0, height = 0;  ///< 0 x 0 when compressed
    std::size_t step = 0;       ///< bytes from row to row; 0 when compressed
    bool bigEndian = false;     ///< of 16 and 32-bit values; raw pictures only
    SharedBytes content;        ///< raw: at least height * step bytes
};

/// Calibration of a camera (sensor_msgs/msg/CameraInfo).
struct CameraInfoSample {
    SampleHeader header;
    int width = 0, height = 0;              ///< of the picture that it was calibrated with [px]
    std::string distortionModel;            ///< "plumb_bob", "rational_polynomial", "equidistant", "mei"
    std::vector<double> distortion;         ///< parameters of the model, in its order
    std::array<double, 9> intrinsics{};     ///< K: fx 0 cx 0 fy cy 0 0 1; all 0 when uncalibrated [px]
    std::array<double, 9> rectification{};  ///< R, row-major
    std::array<double, 12> projection{};    ///< P, row-major
    int binningX = 1, binningY = 1;         ///< camera pixels binned into one picture pixel
    int roiX = 0, roiY = 0, roiWidth = 0, roiHeight = 0;  ///< 0 x 0: the whole picture [px]
};

}  // namespace leitstand
