#include <algorithm>

#include "core/event/all_samples.h"
#include "core/perception/pictures/coding/depth_file.h"
#include "core/perception/pictures/coding/picture_encoding.h"
#include "core/perception/pictures/coding/picture_file.h"
#include "core/perception/pictures/video/video_bitstream.h"
#include "core/perception/pictures/video/video_packet.h"
#include "messages/ffmpeg_image_transport_msgs.h"
#include "messages/foxglove_msgs.h"
#include "messages/sensor_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

constexpr int MostPixels = 65'535;          // a side of any picture
constexpr std::size_t MostParameters = 64;  // of any distortion model

/// Checks that a row of @p width pixels fits into @p step bytes, and @p height rows into @p size bytes.
void checkRaw(const PictureEncoding& encoding, std::uint64_t width, std::uint64_t height, std::uint64_t step,
              std::uint64_t size, Checks& checks) {
    checks.require(width > 0 && height > 0 && width <= MostPixels && height <= MostPixels, "width",
                   "expected 1 to {} pixels a side, found {} x {}", MostPixels, width, height);
    checks.require(step >= width * encoding.pixelSize, "step", "expected at least {} bytes, found {}",
                   width * encoding.pixelSize, step);
    checks.require(size >= step * height, "data", "expected {} rows of {} bytes, found {} bytes", height,
                   step, size);
    const bool pairs =
        encoding.layout == PictureEncoding::Layout::Yuyv || encoding.layout == PictureEncoding::Layout::Uyvy;
    checks.require(!pairs || width % 2 == 0, "width", "expected pairs of pixels, found {}", width);
}

/// Takes a picture of a video with the codec @p format; @p field holds its name.
void readVideo(const char* field, const std::string& format, const SharedBytes& content, PictureSample& to,
               Checks& checks) {
    to.compressed = true;
    to.encoding = format;
    to.content = content;
    const auto codec = videoCodecOf(format);
    checks.require(codec.has_value(), field, "expected H.264 or H.265, \"{}\" cannot be shown",
                   format.substr(0, 40));
    checks.require(hasStartCode(content.bytes), "data",
                   "expected NAL units with start codes (Annex B), found {} other bytes",
                   content.bytes.size());
    if (!checks.ok()) return;
    to.video = std::make_shared<const VideoPacket>(
        VideoPacket{.codec = *codec, .key = isKeyPicture(*codec, content.bytes), .bytes = content});
}

void requireVideo(const PictureSample& from, Checks& checks) {
    checks.require(from.video != nullptr, "data", "expected a picture of a video, found \"{}\"",
                   from.encoding);
}

template <std::size_t N>
std::array<double, N> finite(const char* field, const std::array<double, N>& values, Checks& checks) {
    for (const double value : values) checks.finite(field, value);
    return values;
}

}  // namespace

PictureSample fromWire(const wire::sensor_msgs::Image& from, const Source& source, Checks& checks) {
    PictureSample to;
    to.header = checks.header(from.header);
    const PictureEncoding* encoding = findPictureEncoding(from.encoding);
    checks.require(encoding != nullptr, "encoding", "\"{}\" cannot be shown", from.encoding.substr(0, 40));
    if (encoding == nullptr || !checks.ok()) return to;
    checkRaw(*encoding, from.width, from.height, from.step, from.data.size(), checks);
    to.encoding = from.encoding;
    to.width = checks.size("width", from.width, MostPixels);
    to.height = checks.size("height", from.height, MostPixels);
    to.step = from.step;
    to.bigEndian = from.is_bigendian != 0;
    to.content = {source.cdr, from.data};
    return to;
}

void toWire(const PictureSample& from, wire::sensor_msgs::Image& to, Buffer&, Checks& checks) {
    const PictureEncoding* encoding = findPictureEncoding(from.encoding);
    checks.require(!from.compressed && encoding != nullptr, "encoding",
                   "expected an uncompressed picture, found \"{}\"", from.encoding);
    if (encoding == nullptr || !checks.ok()) return;
    checkRaw(*encoding, checks.wireSize("width", from.width), checks.wireSize("height", from.height),
             from.step, from.content.bytes.size(), checks);
    checks.require(from.step <= UINT32_MAX, "step", "expected less than 2^32, found {}", from.step);
    to.header = checks.wireHeader(from.header);
    to.height = checks.wireSize("height", from.height);
    to.width = checks.wireSize("width", from.width);
    to.encoding = from.encoding;
    to.is_bigendian = from.bigEndian ? 1 : 0;
    to.step = static_cast<std::uint32_t>(from.step);
    to.data = from.content.bytes;
}

PictureSample fromWire(const wire::sensor_msgs::CompressedImage& from, const Source& source, Checks& checks) {
    PictureSample to;
    to.header = checks.header(from.header);
    // Some cameras send videos under this type, too.
    if (hasStartCode(from.data) && videoCodecOf(from.format)) {
        readVideo("format", from.format, {source.cdr, from.data}, to, checks);
        return to;
    }
    to.compressed = true;
    to.encoding = from.format;
    to.content = {source.cdr, from.data};
    if (depth_file::isDepth(from.format)) {
        const auto checked = depth_file::check(to);
        checks.require(checked.ok(), "data", "{}", checked ? std::string() : checked.error().text);
        return to;
    }
    checks.require(pictureFileKind(from.data) != PictureFileKind::Unknown, "data",
                   "expected a JPEG or PNG file, found {} other bytes (format \"{}\")", from.data.size(),
                   from.format.substr(0, 40));
    return to;
}

void toWire(const PictureSample& from, wire::sensor_msgs::CompressedImage& to, Buffer&, Checks& checks) {
    checks.require(from.compressed, "format", "expected a compressed picture, found \"{}\"", from.encoding);
    to = {checks.wireHeader(from.header), from.encoding, from.content.bytes};
}

PictureSample fromWire(const wire::ffmpeg_image_transport_msgs::FFMPEGPacket& from, const Source& source,
                       Checks& checks) {
    PictureSample to;
    to.header = checks.header(from.header);
    checks.require(
        from.width >= 0 && from.height >= 0 && from.width <= MostPixels && from.height <= MostPixels, "width",
        "expected at most {} pixels a side, found {} x {}", MostPixels, from.width, from.height);
    // What stands behind the codec says how its pictures were converted.
    readVideo("encoding", from.encoding.substr(0, from.encoding.find(';')), {source.cdr, from.data}, to,
              checks);
    to.width = from.width;
    to.height = from.height;
    return to;
}

void toWire(const PictureSample& from, wire::ffmpeg_image_transport_msgs::FFMPEGPacket& to, Buffer&,
            Checks& checks) {
    constexpr std::uint8_t Key = 1;  // AV_PKT_FLAG_KEY
    requireVideo(from, checks);
    if (!checks.ok()) return;
    to.header = checks.wireHeader(from.header);
    to.width = from.width;
    to.height = from.height;
    to.encoding = from.encoding;
    to.pts = static_cast<std::uint64_t>(from.header.stamp.time_since_epoch().count());
    to.flags = from.video->key ? Key : 0;
    to.data = from.content.bytes;
}

PictureSample fromWire(const wire::foxglove_msgs::CompressedVideo& from, const Source& source,
                       Checks& checks) {
    PictureSample to;
    to.header = checks.header({from.timestamp, from.frame_id});
    readVideo("format", from.format, {source.cdr, from.data}, to, checks);
    return to;
}

void toWire(const PictureSample& from, wire::foxglove_msgs::CompressedVideo& to, Buffer&, Checks& checks) {
    requireVideo(from, checks);
    const wire::std_msgs::Header header = checks.wireHeader(from.header);
    to = {header.stamp, header.frame_id, from.content.bytes, from.encoding};
}

CameraInfoSample fromWire(const wire::sensor_msgs::CameraInfo& from, const Source&, Checks& checks) {
    CameraInfoSample to;
    to.header = checks.header(from.header);
    to.width = checks.size("width", from.width, MostPixels);
    to.height = checks.size("height", from.height, MostPixels);
    to.distortionModel = from.distortion_model;
    checks.require(from.d.size() <= MostParameters, "d", "expected at most {} parameters, found {}",
                   MostParameters, from.d.size());
    for (const double value : from.d) checks.finite("d", value);
    to.distortion = from.d;
    to.intrinsics = finite("k", from.k, checks);
    to.rectification = finite("r", from.r, checks);
    to.projection = finite("p", from.p, checks);
    to.binningX = std::max(1, checks.size("binning_x", from.binning_x, MostPixels));
    to.binningY = std::max(1, checks.size("binning_y", from.binning_y, MostPixels));
    to.roiX = checks.size("roi.x_offset", from.roi.x_offset, MostPixels);
    to.roiY = checks.size("roi.y_offset", from.roi.y_offset, MostPixels);
    to.roiWidth = checks.size("roi.width", from.roi.width, MostPixels);
    to.roiHeight = checks.size("roi.height", from.roi.height, MostPixels);
    return to;
}

void toWire(const CameraInfoSample& from, wire::sensor_msgs::CameraInfo& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.height = checks.wireSize("height", from.height);
    to.width = checks.wireSize("width", from.width);
    to.distortion_model = from.distortionModel;
    to.d = from.distortion;
    to.k = finite("k", from.intrinsics, checks);
    to.r = finite("r", from.rectification, checks);
    to.p = finite("p", from.projection, checks);
    to.binning_x = checks.wireSize("binning_x", from.binningX);
    to.binning_y = checks.wireSize("binning_y", from.binningY);
    to.roi = {checks.wireSize("roi.x_offset", from.roiX), checks.wireSize("roi.y_offset", from.roiY),
              checks.wireSize("roi.height", from.roiHeight), checks.wireSize("roi.width", from.roiWidth),
              false};
}

std::vector<Conversion> pictureConversions() {
    return {
        conversion<wire::sensor_msgs::Image, PictureSample>(),
        conversion<wire::sensor_msgs::CompressedImage, PictureSample>(),
        conversion<wire::ffmpeg_image_transport_msgs::FFMPEGPacket, PictureSample>(),
        conversion<wire::foxglove_msgs::CompressedVideo, PictureSample>(),
        conversion<wire::sensor_msgs::CameraInfo, CameraInfoSample>(),
    };
}

}  // namespace leitstand::detail
