#include "transport/convert/encode.h"

#include <algorithm>

#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/status_samples.h"
#include "messages/ffmpeg_image_transport_msgs.h"
#include "messages/geometry_msgs.h"
#include "messages/sensor_msgs.h"
#include "transport/convert/detail/conversion.h"
#include "transport/convert/readings/reading_conversion.h"

namespace leitstand {

Result<Payload> encode(const Sample& sample, std::string_view type) {
    if (const auto* reading = sample.as<ReadingSample>()) {
        auto payload = detail::encodeReading(*reading, type);
        return payload ? std::move(payload) : Error{fmt::format("{}: {}", type, payload.error().text)};
    }
    const auto& all = detail::conversions();
    const auto ofType = [&](const detail::Conversion& entry) {
        return entry.encode != nullptr && entry.type == type;
    };
    const auto found = std::find_if(all.begin(), all.end(), ofType);
    if (found == all.end()) return Error{fmt::format("{}: Leitstand sends no such messages", type)};
    auto payload = found->encode(sample);
    if (!payload) return Error{fmt::format("{}: {}", type, payload.error().text)};
    return payload;
}

std::string_view typeOf(const Sample& sample) {
    if (const auto* twist = sample.as<TwistSample>(); twist != nullptr && twist->stamp) {
        return wire::geometry_msgs::TwistStamped::RosName;
    }
    if (const auto* picture = sample.as<PictureSample>(); picture != nullptr && picture->compressed) {
        return picture->video ? wire::ffmpeg_image_transport_msgs::FFMPEGPacket::RosName
                              : wire::sensor_msgs::CompressedImage::RosName;
    }
    const auto& all = detail::conversions();
    const auto found = std::find_if(all.begin(), all.end(), [&](const detail::Conversion& entry) {
        return entry.encode != nullptr && entry.kind == sample.index();
    });
    return found != all.end() ? found->type : std::string_view();
}

std::optional<Time> commandStamp(StampSource source, Time now, std::chrono::nanoseconds ahead) {
    switch (source) {
        case StampSource::Robot:
            return now + ahead;
        case StampSource::Zero:
            return std::nullopt;
        case StampSource::Station:
            return now;
    }
    return std::nullopt;
}

}  // namespace leitstand
