#include "app/services/finds/evidence_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/words.h"
#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/heat/heat_picture.h"
#include "core/perception/pictures/coding/picture_decoding.h"

namespace leitstand {
namespace {

const StreamDescription* streamOf(const std::vector<RobotDescription>& robots, const Event& event) {
    for (const RobotDescription& robot : robots) {
        for (const StreamDescription& stream : robot.streams) {
            if (stream.topic == event.topic && robot.name == event.robot) return &stream;
        }
    }
    return nullptr;
}

}  // namespace

Result<EvidencePicture> evidencePicture(const PictureSample& sample, const Event& event,
                                        const std::vector<RobotDescription>& robots) {
    auto decoded = decodePicture(sample);
    if (!decoded) return decoded.error();
    EvidencePicture made{
        .robot = event.robot, .sensor = event.sensor, .at = event.received, .hottest = {}, .picture = {}};
    const StreamDescription* stream = streamOf(robots, event);
    if (stream != nullptr && stream->role == StreamRole::Thermal) {
        const auto heat = temperatures(*decoded, stream->thermal);
        if (heat) {
            float hottest = -1000.0F;
            for (const float celsius : heat->celsius)
                hottest = std::max(hottest, std::isnan(celsius) ? hottest : celsius);
            made.picture = heatPicture(*heat);
            if (hottest > -1000.0F) made.hottest = hottest;
            return made;
        }
    }
    made.picture = std::move(decoded).value();
    const bool shows =
        made.picture.pixel == Picture::Pixel::Rgb8 || made.picture.pixel == Picture::Pixel::Grey8;
    if (!shows)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: is no picture that can be printed"),
                                     event.topic)};
    return made;
}

}  // namespace leitstand
