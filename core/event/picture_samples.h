#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/shared_bytes.h"
#include "core/base/unknown.h"
#include "core/event/sample_header.h"

namespace leitstand {

struct VideoPacket;

/// A picture as it was sent, not decoded. Its bytes are those of the message and are never copied.
struct PictureSample {
    SampleHeader header;
    bool compressed = false;  ///< whether the bytes are a JPEG or PNG file, or a picture of a video
    std::string encoding;     ///< ROS name, "bgr8", "16UC1"; if compressed: the format as it was sent, "jpeg"
    int width = 0, height = 0;  ///< 0 x 0 if compressed, but for videos that tell their size
    std::size_t step = 0;       ///< number of bytes from one row to the next; 0 if compressed
    bool bigEndian = false;     ///< byte order of 16 and 32-bit values; only for raw pictures
    SharedBytes content;        ///< at least height * step bytes if raw
    /// Null: it is no picture of a video. Otherwise its bytes are the content, and EventDecoder adds the
    /// pictures before it.
    std::shared_ptr<const VideoPacket> video{};
};

/// Calibration of a camera (sensor_msgs/msg/CameraInfo).
struct CameraInfoSample {
    SampleHeader header;
    int width = 0, height = 0;              ///< size of the pictures with which it was calibrated [px]
    std::string distortionModel;            ///< "plumb_bob", "rational_polynomial", "equidistant", "mei"
    std::vector<double> distortion;         ///< parameters of the model, in the model's order
    std::array<double, 9> intrinsics{};     ///< K: fx 0 cx 0 fy cy 0 0 1; all 0: not calibrated [px]
    std::array<double, 9> rectification{};  ///< R, row by row
    std::array<double, 12> projection{};    ///< P, row by row
    /// Number of camera pixels that are binned into one pixel of the picture.
    int binningX = 1, binningY = 1;
    /// Part of the picture that is sent; 0 x 0: the whole picture [px].
    int roiX = 0, roiY = 0, roiWidth = 0, roiHeight = 0;
};

/// Something that a detector sees in a picture of a camera.
struct Detection {
    /// Middle of its box [px]: x to the right, y down, from the picture's upper left corner.
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d size = Eigen::Vector2d::Zero();  ///< width and height of the box before it is turned [px]
    double turned = 0.0;                             ///< rotation of the box, clockwise in the picture [rad]
    std::string label;                               ///< what it is most likely, "person"; may be empty
    double score = Unknown;                          ///< how sure the detector is, usually 0 to 1
};

/// What a detector sees in one picture (vision_msgs/msg/Detection2DArray). The header is that of the picture.
struct DetectionsSample {
    static constexpr std::size_t Most = 500;
    SampleHeader header;
    std::vector<Detection> detections;
};

}  // namespace leitstand
