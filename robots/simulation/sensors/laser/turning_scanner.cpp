#include "robots/simulation/sensors/laser/turning_scanner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/sample_header.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr std::chrono::seconds LongestLag(3);  ///< the world keeps poses for little longer

}  // namespace

TurningScannerSettings scanDrive() {
    return {};
}

TurningScannerSettings turningUrg() {
    TurningScannerSettings settings;
    settings.pattern.rawScans = 60;
    settings.pattern.points = 445;
    settings.pattern.step = degrees(0.36);
    settings.pattern.shotsOfCircle = 1000.0;
    settings.pattern.turn = std::chrono::seconds(6);
    settings.pattern.slice = std::chrono::milliseconds(500);
    settings.laser.nearest = 0.06;
    settings.laser.farthest = 4.0;
    settings.laser.deviation = 0.005;
    settings.laser.deviationOfRange = 0.01;
    settings.laser.divergence = 0.003;
    return settings;
}

TurningScanner::TurningScanner(const TurningScannerSettings& settings, const Noise& noise, Time start)
    : m_settings(settings), m_head(settings.laser, noise), m_start(start) {
    m_rays.resize(static_cast<std::size_t>(settings.pattern.points));
}

void TurningScanner::aim(const World& world, int robot) {
    const TurningPattern& pattern = m_settings.pattern;
    const Time start = startOf(m_rawScan);
    for (int point = 0; point < pattern.points; ++point) {
        const Pose mount =
            world.baseInArena(robot, start + pattern.shotAfter(point)) * m_settings.mountInBase;
        Ray& ray = m_rays[static_cast<std::size_t>(point)];
        ray.origin = mount.translation().cast<float>();
        ray.direction = (mount.linear() * pattern.direction(m_rawScan, point)).cast<float>();
    }
}

void TurningScanner::append(std::span<const LaserEcho> echoes, int ring, CloudSample& slice) const {
    const TurningPattern& pattern = m_settings.pattern;
    const Time start = startOf(m_rawScan);
    if (slice.rows == 0) slice.header = {start, m_settings.frame};
    ++slice.rows;
    slice.columns = pattern.points;
    for (int point = 0; point < pattern.points; ++point) {
        const LaserEcho& echo = echoes[static_cast<std::size_t>(point)];
        slice.points.emplace_back(pattern.direction(m_rawScan, point).cast<float>() * echo.range);
        slice.intensities.push_back(echo.intensity);
        slice.times.push_back((start + pattern.shotAfter(point) - slice.header.stamp).count());
        slice.rings.push_back(ring);
    }
}

void TurningScanner::publishFan(std::span<const LaserEcho> echoes, std::vector<HardwareSample>& samples) {
    const TurningPattern& pattern = m_settings.pattern;
    const SampleHeader header{startOf(m_rawScan), m_settings.fanFrame};
    Pose fanInMount = Pose::Identity();  // x: the heading, y: up
    fanInMount.linear() = (Eigen::AngleAxisd(pattern.heading(m_rawScan), Eigen::Vector3d::UnitZ()) *
                           Eigen::AngleAxisd(degrees(90), Eigen::Vector3d::UnitX()))
                              .toRotationMatrix();
    samples.push_back({StreamRole::Transforms,
                       {},
                       TransformsSample{{{{header.stamp, m_settings.frame}, header.frame, fanInMount}}}});
    RangesSample ranges;
    ranges.header = header;
    ranges.angleMin = pattern.lowest;
    ranges.angleStep = pattern.step;
    ranges.timeStep = toSeconds(pattern.shotAfter(1));
    ranges.turnTime = toSeconds(pattern.turn) / pattern.rawScans;
    ranges.rangeMin = m_settings.laser.nearest;
    ranges.rangeMax = m_settings.laser.farthest;
    for (const LaserEcho& echo : echoes) ranges.ranges.push_back(echo.range);
    samples.push_back({StreamRole::Ranges, m_settings.rangesSensor, std::move(ranges)});
}

void TurningScanner::emitSlice(CloudSample& slice, Reach reach, std::vector<HardwareSample>& samples) const {
    if (slice.rows == 0) return;
    samples.push_back({StreamRole::Points, m_settings.sensor, std::exchange(slice, {}), reach});
}

void TurningScanner::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    const TurningPattern& pattern = m_settings.pattern;
    const auto lag = world.now() - LongestLag - m_start;
    const Reach whole = m_enabled && !isThinned() ? Reach::Everywhere : Reach::OnBoard;
    const auto emitAll = [&] {
        emitSlice(m_slice, whole, samples);
        emitSlice(m_sent, Reach::Sent, samples);
    };
    if (pattern.startOf(m_rawScan) < lag) {
        emitAll();
        m_rawScan = pattern.firstFrom(lag);
    }
    const auto rawScanTime = pattern.shotAfter(pattern.points - 1);
    const CastRays cast = castInto(world.scene(), RayKind::Laser);
    for (; startOf(m_rawScan) + rawScanTime <= world.now(); ++m_rawScan) {
        const bool ranges = m_rangesEnabled && !m_settings.fanFrame.empty();
        const bool begins = pattern.row(m_rawScan) == 0;
        aim(world, robot);
        const std::span<const LaserEcho> echoes = m_head.measure(m_rays, cast);
        if (ranges) publishFan(echoes, samples);
        // The raw scan that begins a turn also closes the one before, whose last slice waits for it.
        for (CloudSample* slice : {&m_slice, &m_sent}) {
            if (begins && slice->rows > 0) append(echoes, pattern.rawScans, *slice);
        }
        if (begins) emitAll();
        append(echoes, pattern.row(m_rawScan), m_slice);
        if (isThinned() && pattern.row(m_rawScan) % m_every == 0)
            append(echoes, pattern.row(m_rawScan), m_sent);
        if (pattern.row(m_rawScan + 1) == 0) continue;  // the next raw scan ends the turn
        const auto slice = pattern.sliceOf(m_rawScan), next = pattern.sliceOf(m_rawScan + 1);
        if (next != slice) emitSlice(m_slice, whole, samples);
        if (next / m_every != slice / m_every) emitSlice(m_sent, Reach::Sent, samples);
    }
}

bool TurningScanner::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (role == StreamRole::Points && sensor == m_settings.sensor) {
        m_enabled = settings.enabled;
        // The scanner turns at a fixed speed. At a lower rate, slices are longer and leave out raw scans, so
        // that turns stay whole and have fewer columns.
        const double usual = 1.0 / toSeconds(m_settings.pattern.slice);
        m_every =
            settings.rate > 0.0 ? std::max(1, static_cast<int>(std::ceil(usual / settings.rate - 1e-6))) : 1;
        if (!isThinned()) m_sent = {};
        return true;
    }
    if (role == StreamRole::Ranges && !m_settings.fanFrame.empty() && sensor == m_settings.rangesSensor) {
        m_rangesEnabled = settings.enabled;
        return true;
    }
    return false;
}

}  // namespace leitstand::simulation
