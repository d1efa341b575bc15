#include "widgets/models/camera/detection_marks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds FarthestApart{1};

bool isOnlyCamera(const RobotDescription& robot, const std::string& sensor) {
    std::set<std::string> cameras;
    for (const StreamDescription& stream : robot.streams)
        if (stream.role == StreamRole::Picture) cameras.insert(stream.sensor);
    return cameras.size() == 1 && cameras.contains(sensor);
}

bool isOfCamera(const RobotDescription& robot, const std::string& topic, const std::string& frame,
                const PictureUnderDetections& picture) {
    const auto stream = std::find_if(robot.streams.begin(), robot.streams.end(),
                                     [&](const StreamDescription& one) { return one.topic == topic; });
    if (stream != robot.streams.end() && !stream->sensor.empty()) return stream->sensor == picture.sensor;
    if (!frame.empty() && !picture.frame.empty()) return frame == picture.frame;
    return isOnlyCamera(robot, picture.sensor);
}

bool isNear(Time a, Time b) {
    return a - b <= FarthestApart && b - a <= FarthestApart;
}

DetectionMark markOf(const Detection& detection, const PictureUnderDetections& picture) {
    DetectionMark mark;
    const QPointF along(std::cos(detection.turned), std::sin(detection.turned));
    const QPointF across(-along.y(), along.x());
    const QPointF middle(detection.centre.x(), detection.centre.y());
    const QPointF half = 0.5 * detection.size.x() * along, other = 0.5 * detection.size.y() * across;
    mark.corners = {middle - half - other, middle + half - other, middle + half + other,
                    middle - half + other};
    for (QPointF& corner : mark.corners)
        corner = QPointF(corner.x() / picture.width, corner.y() / picture.height);
    mark.text = othersText(detection.label);
    if (detection.score >= 0.0 && detection.score <= 1.0) {
        if (!mark.text.isEmpty()) mark.text += QLatin1Char(' ');
        mark.text += percentText(detection.score);
    }
    return mark;
}

}  // namespace

std::vector<DetectionMark> detectionMarks(const RobotDescription& robot, const RobotState& reported,
                                          const PictureUnderDetections& picture) {
    std::vector<DetectionMark> marks;
    if (picture.width <= 0 || picture.height <= 0) return marks;
    for (const auto& [topic, latest] : reported.detections) {
        const DetectionsSample& seen = latest->sample;
        const bool stamped = seen.header.stamp != Time{} && picture.stamp != Time{};
        const bool near =
            stamped ? isNear(seen.header.stamp, picture.stamp) : isNear(latest->received, picture.received);
        if (!near || !isOfCamera(robot, topic, seen.header.frame, picture)) continue;
        for (const Detection& detection : seen.detections) marks.push_back(markOf(detection, picture));
    }
    return marks;
}

}  // namespace leitstand
