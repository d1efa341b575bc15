#include "app/services/finds/freezing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "core/event/all_samples.h"
#include "core/event/find_sample.h"
#include "core/event/picture_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/heat/heat.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/sharpness.h"

namespace leitstand {
namespace {

constexpr std::size_t MostCompared = 12;  // pictures of a camera: 15 Hz for 3 s are decoded in part
constexpr double GasRise = 150.0;         // over the least of the last minute [ppm]
constexpr double Crosshair = degrees(2.0);
constexpr std::chrono::seconds GasStep{1};  // of the trace: the highest reading of each is kept

Time stampOf(const Event& event) {
    const auto stamp = visit(
        [](const auto& sample) -> Time {
            if constexpr (requires { sample.header.stamp; }) return sample.header.stamp;
            return {};
        },
        event.sample);
    return stamp == Time() ? event.received : stamp;
}

bool isEvidence(const FrozenEvidence& frozen, const Event& event) {
    return std::any_of(frozen.evidence.begin(), frozen.evidence.end(), [&](const VictimEvidence& one) {
        return one.sequence == event.sequence && one.topic == event.topic;
    });
}

struct Sharpest {
    const Event* event = nullptr;
    int width = 0, height = 0;
};

Sharpest sharpestOf(const std::vector<Event>& pictures) {
    Sharpest best;
    double most = -1.0;
    if (pictures.empty()) return best;
    const std::size_t step = std::max<std::size_t>(1, pictures.size() / MostCompared);
    PictureDecoder decoder;  // pictures of a video follow each other
    for (std::size_t i = (pictures.size() - 1) % step; i < pictures.size(); i += step) {  // with the newest
        const Event& event = pictures[i];
        const auto* sample = event.sample.as<PictureSample>();
        if (sample == nullptr) continue;
        const auto picture = decoder.decode(*sample);
        if (!picture) continue;
        const double sharp = sharpness(*picture);
        if (sharp < most) continue;
        most = sharp;
        best = {&event, picture->width, picture->height};
    }
    return best;
}

/// Returns the picture that @p at points into; none: it is gone already or cannot be read.
Sharpest pointedOf(const std::vector<Event>& pictures, const PicturePoint& at) {
    for (auto event = pictures.rbegin(); event != pictures.rend(); ++event) {
        const auto* sample = event->sample.as<PictureSample>();
        if (sample == nullptr || (at.sequence != 0 && event->sequence != at.sequence)) continue;
        if (const auto picture = decodePicture(*sample)) return {&*event, picture->width, picture->height};
    }
    return {};
}

/// The newest thermal picture that shows a body, else the newest.
struct Hottest {
    const Event* event = nullptr;
    int width = 0, height = 0;
    std::optional<HeatBlob> blob;
};

Hottest hottestOf(const std::vector<Event>& pictures, const CameraInfoSample& camera,
                  const ThermalScale& scale) {
    Hottest found;
    const std::size_t step = std::max<std::size_t>(1, pictures.size() / MostCompared);
    for (std::size_t i = pictures.size(); i > 0 && !found.blob; i -= std::min(i, step)) {
        const Event& event = pictures[i - 1];
        const auto* sample = event.sample.as<PictureSample>();
        if (sample == nullptr) continue;
        const auto picture = decodePicture(*sample);
        const auto thermal = picture ? temperatures(*picture, scale) : Error{};
        if (!thermal) continue;
        const auto blobs = findHeat(*thermal, camera);
        const bool body = !blobs.empty() && blobs.front().kind == HeatBlob::Kind::Body;
        if (found.event != nullptr && !body) continue;
        found = {&event, thermal->width, thermal->height, std::nullopt};
        if (body) found.blob = blobs.front();
    }
    return found;
}

/// Returns the body in the thermal picture @p pointed that is nearest to @p share of it. The operator may
/// mean a hand that is cooler than the head beside it.
Hottest pointedBodyOf(const Sharpest& pointed, const Eigen::Vector2d& share, const CameraInfoSample& camera,
                      const ThermalScale& scale) {
    Hottest found{pointed.event, pointed.width, pointed.height, std::nullopt};
    const auto* sample = pointed.event->sample.as<PictureSample>();
    const auto picture = sample != nullptr ? decodePicture(*sample) : Error{};
    const auto thermal = picture ? temperatures(*picture, scale) : Error{};
    if (!thermal) return found;
    const Eigen::Vector2d pixel(share.x() * pointed.width, share.y() * pointed.height);
    for (const HeatBlob& blob : findHeat(*thermal, camera)) {
        if (blob.kind != HeatBlob::Kind::Body) break;  // bodies come first
        if (!found.blob || (blob.centre - pixel).norm() < (found.blob->centre - pixel).norm())
            found.blob = blob;
    }
    return found;
}

void chooseGas(const std::vector<Event>& gas, FrozenEvidence& frozen) {
    double least = INFINITY, newest = Unknown;
    const Event* last = nullptr;
    // By whole seconds of the clock: two finds of one minute share their readings.
    std::map<std::pair<std::string, std::int64_t>, std::pair<const Event*, double>> trace;
    for (const Event& event : gas) {
        const auto* sample = event.sample.as<GasSample>();
        if (sample == nullptr || sample->gas != "co2" || !std::isfinite(sample->ppm)) continue;
        least = std::min(least, sample->ppm);
        newest = sample->ppm;
        last = &event;
        const auto step = event.received.time_since_epoch() / std::chrono::nanoseconds(GasStep);
        auto& kept = trace.try_emplace({event.topic, step}, &event, sample->ppm).first->second;
        if (sample->ppm > kept.second) kept = {&event, sample->ppm};
    }
    if (newest - least >= GasRise) frozen.co2 = newest;
    if (last == nullptr && !gas.empty()) last = &gas.back();  // of another gas, or broken: it shows so
    for (const auto& [step, kept] : trace) {
        if (kept.first != last) frozen.evidence.push_back(evidenceOf("gas", *kept.first));
    }
    if (last != nullptr) frozen.evidence.push_back(evidenceOf("gas", *last));
}

void lookThrough(ChosenEvidence& chosen, const Event& picture, int width, int height,
                 const Eigen::Vector2d& pixel, double halfAngle) {
    chosen.picture = picture;
    chosen.width = width;
    chosen.height = height;
    chosen.pixel = pixel;
    chosen.halfAngle = halfAngle;
}

}  // namespace

VictimEvidence evidenceOf(const char* kind, const Event& event) {
    return {kind, event.topic, event.sequence, stampOf(event)};
}

ChosenEvidence chooseEvidence(const RobotDescription& robot, const RobotEvidence& recent,
                              FindSample::Kind kind, const std::string& looksThrough,
                              const std::optional<PicturePoint>& at) {
    ChosenEvidence chosen;
    bool atHotSpot = false;
    chosen.frozen.robot = robot.name;
    const std::string aimed = at ? at->sensor : looksThrough;
    const Eigen::Vector2d share = at ? at->share : Eigen::Vector2d(0.5, 0.5);
    const auto aim = [&](const std::string& sensor, const Event& event, int width, int height) {
        if (sensor != aimed || !recent.cameras.contains(sensor)) return;
        lookThrough(chosen, event, width, height, {share.x() * width, share.y() * height}, Crosshair);
    };
    const auto pointedIn = [&](const std::string& sensor, const std::vector<Event>& pictures) {
        return at && sensor == aimed ? pointedOf(pictures, *at) : Sharpest();
    };
    for (const auto& [sensor, pictures] : recent.pictures) {
        const Sharpest pointed = pointedIn(sensor, pictures);
        const Sharpest best = pointed.event != nullptr ? pointed : sharpestOf(pictures);
        if (best.event == nullptr) continue;
        chosen.frozen.evidence.push_back(evidenceOf("picture", *best.event));
        // A pixel of a picture that is gone means nothing in another one.
        if (!at || pointed.event != nullptr) aim(sensor, *best.event, best.width, best.height);
    }
    for (const auto& [sensor, pictures] : recent.thermal) {
        const StreamDescription* stream = robot.stream(StreamRole::Thermal, sensor);
        const auto camera = recent.cameras.find(sensor);
        if (stream == nullptr) continue;
        const CameraInfoSample info = camera == recent.cameras.end() ? CameraInfoSample() : camera->second;
        const Sharpest pointed = pointedIn(sensor, pictures);
        const Hottest hottest = pointed.event != nullptr
                                    ? pointedBodyOf(pointed, share, info, stream->thermal)
                                    : hottestOf(pictures, info, stream->thermal);
        if (hottest.event == nullptr) continue;
        chosen.frozen.evidence.push_back(evidenceOf("thermal", *hottest.event));
        if (pointed.event != nullptr || (!at && !atHotSpot))
            aim(sensor, *hottest.event, hottest.width, hottest.height);
        if (!hottest.blob) continue;
        chosen.frozen.heat = hottest.blob->peak;
        // For a sign or a code beside a body, the operator's aim counts, not the warmth.
        if (at || kind != FindSample::Kind::Victim || camera == recent.cameras.end()) continue;
        atHotSpot = true;
        lookThrough(chosen, *hottest.event, hottest.width, hottest.height, hottest.blob->centre,
                    std::max(Crosshair, 0.4 * std::min(hottest.blob->width, hottest.blob->height)));
    }
    chooseGas(recent.gas, chosen.frozen);
    if (recent.scan) chosen.frozen.evidence.push_back(evidenceOf("scan", *recent.scan));
    if (recent.odometry) chosen.frozen.evidence.push_back(evidenceOf("odometry", *recent.odometry));
    return chosen;
}

std::vector<Event> picturesOf(const FrozenEvidence& frozen, const RobotEvidence& recent, Time since) {
    std::vector<Event> found;
    for (const auto* cameras : {&recent.pictures, &recent.thermal}) {
        for (const auto& [sensor, pictures] : *cameras) {
            std::copy_if(pictures.begin(), pictures.end(), std::back_inserter(found),
                         [&](const Event& picture) {
                             return picture.received >= since && isEvidence(frozen, picture);
                         });
        }
    }
    return found;
}

bool isPictureEvidence(const VictimEvidence& evidence) {
    return evidence.kind == "picture" || evidence.kind == "thermal";
}

FrozenEvidence withPictures(FrozenEvidence frozen, const std::vector<Event>& shown) {
    bool warm = false;
    std::erase_if(frozen.evidence, [&](const VictimEvidence& one) {
        if (!isPictureEvidence(one)) return false;
        const bool kept = std::any_of(shown.begin(), shown.end(), [&](const Event& picture) {
            return picture.sequence == one.sequence && picture.topic == one.topic;
        });
        warm = warm || (kept && one.kind == "thermal");
        return !kept;
    });
    if (!warm) frozen.heat = Unknown;
    return frozen;
}

}  // namespace leitstand
