#include "app/services/review/review_pointing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "app/services/recorded/review_cadence.h"
#include "app/services/recorded/review_log.h"
#include "app/services/review/review_evidence.h"
#include "app/services/review/reviewed_robot.h"
#include "app/services/victims/victim_search.h"
#include "core/base/words.h"
#include "core/event/cloud_sample.h"
#include "core/event/picture_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/stream_role.h"
#include "core/mission/state/scan_state.h"
#include "core/perception/pictures/coding/picture_decoding.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Before(6);           // the surroundings are scanned in less
constexpr std::chrono::milliseconds Settling(700);  // until the odometry of a picture has come
constexpr double Aim = degrees(2.0);                // half angle of what is pointed at, as seen
constexpr std::size_t Turns = 3;                    // whole turns used where slices are missing

Error nothingThere() {
    return Error{translate("leitstand::Station", "nothing was scanned there: point to it on the map")};
}

/// Returns the picture that was pointed into; empty: the log does not have it.
std::optional<Event> pictureOf(ReviewLog& log, const RobotDescription& robot, const PicturePoint& at,
                               Time now) {
    for (const StreamDescription& stream : robot.streams) {
        const bool camera = stream.role == StreamRole::Picture || stream.role == StreamRole::Thermal;
        if (!camera || stream.sensor != at.sensor) continue;
        auto newest = log.newest(stream.topic, now);
        if (newest && (at.sequence == 0 || newest->sequence == at.sequence)) return newest;
        std::optional<Event> found;  // a newer one came since it was shown
        log.events(now - Before, now + Settling, [&](const Event& event) {
            if (event.sequence == at.sequence) found = event;
        });
        if (found) return found;
    }
    return std::nullopt;
}

/// Returns the points of the newest key scans of @p robot, as if its scanner had seen them from @p place at
/// once.
std::optional<Event> lookRound(const RobotDescription& robot, const RobotInMap& place,
                               const ReviewIndex& index, const MissionState& shown, Time before) {
    const StreamDescription* scanner = robot.stream(StreamRole::Points);
    if (scanner == nullptr) return std::nullopt;
    CloudSample cloud;
    cloud.header = {place.stamp, robot.baseFrame};
    std::size_t turns = 0;
    for (auto one = index.keyScans.rbegin(); one != index.keyScans.rend() && turns < Turns; ++one) {
        const auto known = shown.keyScans->find(one->first);
        const ScanPtr& scan = one->second.scan;
        if (!scan || scan->robot != robot.name || one->second.stamp > before ||
            known == shown.keyScans->end() || known->second.pose.trust == ScanTrust::SetAside)
            continue;
        const Eigen::Isometry3f inBase =
            (place.baseInMap.inverse() * known->second.pose.scanInMap).cast<float>();
        for (const Eigen::Vector3f& point : scan->points) cloud.points.push_back(inBase * point);
        ++turns;
    }
    if (turns == 0) return std::nullopt;
    return Event{0, before, robot.name, scanner->topic, scanner->role, scanner->sensor, std::move(cloud)};
}

/// Makes @p search follow the robot about the time of @p picture, so that it can place what the picture
/// shows.
void follow(VictimSearch& search, ReviewLog& log, const RobotDescription& robot, const ReviewIndex& index,
            const Event& picture, Time until) {
    for (const Event& event : index.fixed) search.onEvent(event, false);
    const Time from = picture.received - Before;
    for (const StreamDescription& stream : robot.streams) {
        // The newest sample before counts, however old it is.
        const bool kept = stream.role == StreamRole::Joints || stream.role == StreamRole::Odometry;
        if (!kept && stream.role != StreamRole::CameraInfo) continue;
        if (const auto event = log.newest(stream.topic, kept ? from : until)) search.onEvent(*event, false);
    }
    log.events(from, until, [&](const Event& event) {
        if (event.robot == robot.name) search.onEvent(event, false);
    });
}

}  // namespace

Result<FrozenEvidence> evidenceIn(const std::filesystem::path& mission, const ReviewIndex& index,
                                  const ReviewMoment& moment, const std::string& name,
                                  const MissionState& shown, const PicturePoint& at) {
    const auto log = ReviewLog::open(mission);
    if (!log) return log.error();
    const auto& robots = (*log)->robots();
    const auto robot = std::find_if(robots.begin(), robots.end(),
                                    [&](const RobotDescription& one) { return one.name == name; });
    const auto place = std::find_if(moment.places->begin(), moment.places->end(),
                                    [&](const RobotInMap& one) { return one.robot == name; });
    if (robot == robots.end() || place == moment.places->end() || !place->placed)
        return Error{translate("leitstand::Station", "the robot was not in the map then: nothing was filed")};
    const auto picture = pictureOf(**log, *robot, at, moment.now);
    const auto* const sample = picture ? picture->sample.as<PictureSample>() : nullptr;
    const auto decoded = sample == nullptr ? Result<Picture>(nothingThere()) : decodePicture(*sample);
    if (!decoded) return decoded.error();

    VictimSearch search({*robot}, "review");
    if (!hasSlices(index, name)) {
        // It is looked at when the odometry of its time comes.
        if (const auto around = lookRound(*robot, *place, index, shown, picture->received))
            search.onEvent(*around, false);
    }
    follow(search, **log, *robot, index, *picture, std::max(moment.now, picture->received + Settling));
    search.correct(name, {place->stamp, place->baseInMap, place->certainty, place->certain, place->how});
    const Eigen::Vector2d pixel(at.share.x() * decoded->width, at.share.y() * decoded->height);
    const auto cue = search.locate({*picture, pixel, decoded->width, decoded->height, Aim});
    if (!cue) return nothingThere();
    FrozenEvidence seen = evidenceAt(moment, name, shown, cue->inMap);
    seen.deviation = std::sqrt(cue->covariance.trace() / 3.0);
    const bool kept = std::any_of(seen.evidence.begin(), seen.evidence.end(), [&](const VictimEvidence& one) {
        return one.sequence == picture->sequence;
    });
    if (!kept) {
        const bool thermal = picture->role == StreamRole::Thermal;
        seen.evidence.push_back(evidenceOf(thermal ? "thermal" : "picture", *picture));
    }
    return seen;
}

}  // namespace leitstand
