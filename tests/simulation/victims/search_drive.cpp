#include "tests/simulation/victims/search_drive.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation::test {
namespace {

constexpr double LookRange = 4.0;  // [m]
constexpr float SkinKelvin = 273.15F + 27.5F;
constexpr int EnoughLooks = 8;
constexpr int EnoughTagLooks = 12;  // at 6 Hz: read in three half seconds, and one to spare

// A tag is a code of 21 modules and a quiet zone of 4 on each side, 12 cm wide: a module is 4.1 mm. The left
// camera has 320 pixels in 60 degrees, 277 px a radian about its middle: 2.2 pixels a module, with which
// every picture is read, up to 0.52 m.
constexpr double TagEdge = 0.12, TagModules = 29.0, PixelsOfModule = 2.2;
const double PixelsOfRadian = 160.0 / std::tan(degrees(30.0));

/// Where the tag of @p victim stands in the arena, and where it faces (as the mesh of victims has it).
Ray tagOf(const Element& victim) {
    const double length = victim.size.x();
    Pose plate = victim.pose;
    plate.translate(Eigen::Vector3d(0.16 * length, -0.205 * length, 0.005));
    plate.rotate(Eigen::AngleAxisd(degrees(-15), Eigen::Vector3d::UnitX()));
    Ray ray;
    ray.origin = (plate * Eigen::Vector3d(0.0, -0.001, TagEdge / 2)).cast<float>();
    ray.direction = (-(plate.linear() * Eigen::Vector3d::UnitY())).cast<float>();
    return ray;
}

std::chrono::nanoseconds threadTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

bool VictimTruth::isAsked() const {
    return !hidden && (warm ? looks >= EnoughLooks : tagLooks >= EnoughTagLooks);
}

double fromBody(const Element& element, const Eigen::Vector3d& place) {
    const Eigen::Vector3d inside = element.pose.inverse() * place;
    const Eigen::Vector2d over =
        (inside.head<2>().cwiseAbs() - element.size.head<2>() / 2).cwiseMax(Eigen::Vector2d::Zero());
    return over.norm();
}

SearchDrive::SearchDrive(const Arena& arena, const DriveSetup& setup)
    : driven(arena, setup),
      m_robot(shippedRobot(setup.kind)),
      m_cutter(m_robot.name),
      m_mapper("test", {}),
      m_frames(m_robot) {
    m_mapper.setBody(m_robot.name, {m_robot.footprint, m_robot.height});
    search = std::make_unique<VictimSearch>(std::vector{m_robot}, "test");
    const auto& elements = arena.elements;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (!elements[i].victim) continue;
        VictimTruth truth;
        truth.element = static_cast<int>(i);
        truth.warm = elements[i].victim->temperature >= 28.0;
        truth.hidden = elements[i].victim->hidden;
        victims.push_back(truth);
    }
    for (const StreamDescription& stream : m_robot.streams) {
        if (stream.role != StreamRole::Picture) continue;
        StreamCommandSample on;
        on.topic = stream.topic;
        on.enabled = true;
        on.rate = 6.0;
        driven.station->publish(StreamRole::StreamCommand, on);
    }
    driven.onSample = [this](const HardwareSample& sample) { receive(sample); };
}

Event SearchDrive::eventOf(const HardwareSample& sample) {
    Event event;
    event.sequence = ++m_sequence;
    event.received = driven.world->now();
    event.robot = m_robot.name;
    event.role = sample.role;
    event.sensor = sample.sensor;
    if (const StreamDescription* stream = m_robot.stream(sample.role, sample.sensor))
        event.topic = stream->topic;
    event.sample = sample.sample;
    return event;
}

void SearchDrive::give(const Event& event) {
    if (onEvent) onEvent(event);
    const auto begin = threadTime();
    search->onEvent(event);
    if (event.received >= m_due) {
        m_due = event.received + std::chrono::milliseconds(200);
        for (const CandidateSample& one : search->due(event.received)) {
            candidates[one.id] = one;
            if (!one.dismissed) stood[one.id] = one;
            ++updates;
        }
    }
    worked += threadTime() - begin;
}

void SearchDrive::receive(const HardwareSample& sample) {
    const Event event = eventOf(sample);
    m_frames.add(event);
    give(event);
    map(event);
    look(event);
}

void SearchDrive::map(const Event& event) {
    const Time now = event.received;
    const auto& sensors = m_robot.sensors;
    if (const auto* odometry = event.sample.as<OdometrySample>()) {
        m_cutter.add(*odometry, now);
    } else if (const auto* imu = event.sample.as<ImuSample>()) {
        m_cutter.add(*imu, sensors.at(event.sensor).sensorInBase, now);
    } else if (const auto* cloud = event.sample.as<CloudSample>()) {
        m_cutter.add(*cloud, sensors.at(event.sensor).sensorInBase, now);
    }
    for (const LiveScan& scan : m_cutter.take(now)) {
        const MapUpdate update = m_mapper.add(scan, now);
        const Localisation& here = update.localisation;
        search->correct(m_robot.name,
                        {here.stamp, here.baseInMap, 1.0, here.trust == ScanTrust::Certain, ""});
        Event reported;
        reported.received = now;
        if (update.keyScan) {
            if (!m_mapped) {
                const Pose truth = driven.world->baseInArena(driven.robot, update.keyScan->scan->end);
                m_mapInArena =
                    truth * (update.keyScan->scanInMap * update.keyScan->sensorInBase.inverse()).inverse();
                m_mapped = true;
            }
            reported.sequence = ++m_sequence;
            reported.sample = *update.keyScan;
            give(reported);
        }
        if (update.poses) {
            reported.sequence = ++m_sequence;
            reported.sample = *update.poses;
            give(reported);
        }
    }
}

void SearchDrive::look(const Event& event) {
    const auto* picture = event.sample.as<PictureSample>();
    if (picture == nullptr) return;
    const bool infrared = event.role == StreamRole::Thermal;
    if (!infrared && event.sensor != "left") return;
    const auto inBase = m_frames.inBase(event.sensor, picture->header.frame, picture->header.stamp);
    if (!inBase) return;
    const Pose camera = driven.world->baseInArena(driven.robot, picture->header.stamp) * *inBase;
    infrared ? lookForSkin(camera) : lookForTags(camera);
}

void SearchDrive::lookForSkin(const Pose& camera) {
    std::map<int, int> rays;
    for (int across = -18; across <= 18; across += 2) {
        for (int down = -14; down <= 14; down += 2) {
            Ray ray;
            ray.origin = camera.translation().cast<float>();
            ray.direction =
                (camera.linear() *
                 Eigen::Vector3d(std::tan(degrees(across)), std::tan(degrees(down)), 1.0).normalized())
                    .cast<float>();
            const Hit hit = driven.world->scene().cast(ray, RayKind::Camera, driven.robot);
            if (!hit.there() || hit.surface->element < 0) continue;
            if (hit.distance < LookRange && hit.surface->temperature > SkinKelvin)
                ++rays[hit.surface->element];
        }
    }
    for (VictimTruth& truth : victims) {
        const auto seen = rays.find(truth.element);
        if (seen != rays.end() && seen->second >= 2) ++truth.looks;
    }
}

void SearchDrive::lookForTags(const Pose& camera) {
    const auto& elements = driven.world->arena().elements;
    for (VictimTruth& truth : victims) {
        const Ray tag = tagOf(elements[static_cast<std::size_t>(truth.element)]);
        const Eigen::Vector3d inCamera = camera.inverse() * tag.origin.cast<double>();
        const bool within = inCamera.z() > 0.1 && std::abs(inCamera.x()) < 0.5 * inCamera.z() &&
                            std::abs(inCamera.y()) < 0.37 * inCamera.z();
        if (!within) continue;
        Ray sight;
        sight.origin = camera.translation().cast<float>();
        sight.direction = (tag.origin - sight.origin).normalized();
        const float range = (tag.origin - sight.origin).norm();
        const double facing = -tag.direction.dot(sight.direction);
        if (PixelsOfRadian * TagEdge / TagModules / range * facing < PixelsOfModule) continue;
        const Hit hit = driven.world->scene().cast(sight, RayKind::Camera, driven.robot);
        if (hit.there() && hit.surface->element == truth.element && std::abs(hit.distance - range) < 0.03F)
            ++truth.tagLooks;
    }
}

SearchResult judge(const SearchDrive& drive, const std::string& title) {
    using Kind = FindSample::Kind;
    SearchResult result;
    const auto& elements = drive.driven.world->arena().elements;
    std::printf("%s: %d updates of %zu candidates, %.1f %% of a core\n", title.c_str(), drive.updates,
                drive.candidates.size(),
                100.0 * std::chrono::duration<double>(drive.worked).count() / drive.driven.world->seconds());
    std::map<std::uint32_t, bool> used;
    const auto inArena = [&](const CandidateSample& one) { return drive.mapInArena() * one.positionInMap; };
    for (const VictimTruth& truth : drive.victims) {
        const Element& element = elements[static_cast<std::size_t>(truth.element)];
        const CandidateSample* best = nullptr;
        for (const auto& [id, one] : drive.candidates) {
            if (one.kind != Kind::Victim || one.dismissed) continue;
            const double off = fromBody(element, inArena(one));
            if (off > 0.5) continue;
            if (best == nullptr || off < fromBody(element, inArena(*best))) best = &one;
        }
        const bool asked = truth.isAsked();
        std::printf("  %-10s %-8s %4.1f C, %4.0f ppm%s, %3d looks, %3d at its tag: ", element.name.c_str(),
                    toString(element.victim->situation).c_str(), element.victim->temperature,
                    element.victim->co2, element.victim->waving ? ", waves" : "", truth.looks,
                    truth.tagLooks);
        if (best != nullptr) {
            const Eigen::Vector3d place = inArena(*best);
            const double off = fromBody(element, place);
            std::string kinds;
            for (const Cue& cue : best->cues) kinds += " " + cue.kind;
            std::printf("found %2.0f cm off its body (told %2.0f), %3.0f cm from its middle, sure %.2f:%s\n",
                        100.0 * off, 100.0 * best->deviation,
                        100.0 * (place - element.pose.translation()).head<2>().norm(), best->confidence,
                        kinds.c_str());
            if (asked) result.worst = std::max(result.worst, off);
            used[best->id] = true;
        } else {
            std::printf("%s\n", asked          ? "NOT FOUND"
                                : truth.hidden ? "hidden"
                                : !truth.warm  ? "cold, and its tag was not looked at"
                                               : "not looked at");
        }
        result.lookedAt += asked ? 1 : 0;
        result.found += asked && best != nullptr ? 1 : 0;
        result.coldLookedAt += asked && !truth.warm ? 1 : 0;
        result.coldFound += asked && !truth.warm && best != nullptr ? 1 : 0;
    }
    for (const auto& [id, one] : drive.stood) {
        const bool real = std::any_of(elements.begin(), elements.end(), [&](const Element& element) {
            return element.victim && fromBody(element, inArena(one)) < 0.5;
        });
        if (one.kind == Kind::Victim && !real) ++result.falseEver;
    }
    for (const auto& [id, one] : drive.candidates) {
        const Eigen::Vector3d place = inArena(one);
        if (one.dismissed) continue;
        const Element* nearest = nullptr;
        for (const Element& element : elements) {
            if (one.kind == Kind::Victim && element.kind == ElementKind::Floor) continue;
            if (one.kind == Kind::Victim && element.kind == ElementKind::Wall) continue;
            const bool sign = element.kind == ElementKind::Sign;
            if (one.kind != Kind::Victim && !sign && !element.victim) continue;
            if (nearest == nullptr || fromBody(element, place) < fromBody(*nearest, place))
                nearest = &element;
        }
        const double off = nearest == nullptr ? 99.0 : fromBody(*nearest, place);
        if (one.kind == Kind::Victim) {
            const bool real = nearest != nullptr && nearest->victim && off < 0.5;
            if (used.contains(id)) continue;
            ++result.falseOnes;
            std::string kinds;
            for (const Cue& cue : one.cues) kinds += " " + cue.kind;
            std::printf("  FALSE%s: %.2f %.2f %.2f, sure %.2f, %.0f cm from %s (%.1f C):%s\n",
                        real ? " (second one of a victim)" : "", place.x(), place.y(), place.z(),
                        one.confidence, 100.0 * off, nearest == nullptr ? "?" : nearest->name.c_str(),
                        nearest == nullptr ? 0.0 : nearest->temperature, kinds.c_str());
            continue;
        }
        const std::string text = one.cues.empty() ? "" : one.cues.front().text;
        const bool code = one.kind == Kind::Code;
        bool right = false;
        double nearestSame = 99.0;
        for (const Element& element : elements) {
            const std::string says = element.victim ? "qr:" + element.victim->tag : element.text;
            bool same = code ? says == "qr:" + text : says.starts_with("hazard:");
            if (!code && same) same = text.find(says.substr(7)) != std::string::npos;
            if (!same) continue;
            nearestSame = std::min(nearestSame, (place - element.pose.translation()).head<2>().norm());
        }
        right = nearestSame < (code ? 0.6 : 0.4);
        ++(code ? result.codes : result.hazards);
        if (!right) ++(code ? result.codesWrong : result.hazardsWrong);
        std::printf("  %s \"%s\" at %.2f %.2f %.2f, sure %.2f: %s%.0f cm off\n", code ? "code" : "hazard",
                    text.c_str(), place.x(), place.y(), place.z(), one.confidence, right ? "" : "WRONG, ",
                    100.0 * nearestSame);
    }
    std::printf(
        "  %d of %d looked at found (%d of %d cold), worst %.0f cm, %d false in the end, %d that were ever "
        "told; "
        "%d codes (%d wrong), %d placards (%d wrong)\n",
        result.found, result.lookedAt, result.coldFound, result.coldLookedAt, 100.0 * result.worst,
        result.falseOnes, result.falseEver, result.codes, result.codesWrong, result.hazards,
        result.hazardsWrong);
    return result;
}

}  // namespace leitstand::simulation::test
