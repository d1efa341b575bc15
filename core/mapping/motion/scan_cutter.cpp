#include "core/mapping/motion/scan_cutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/rotation/heading.h"
#include "core/base/time.h"
#include "core/cloud/labels.h"
#include "core/event/motion_samples.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Seam(60);     ///< largest gap between consecutive slices
constexpr std::chrono::seconds LateEnds(1);       ///< late slices are complete after such a pause
constexpr std::chrono::seconds Remembered(150);   ///< stamps of slices, to detect duplicates
constexpr std::chrono::seconds LatestSlice(120);  ///< older ones are of a clock that jumped

/// Least time over which a robot's speed is measured.
constexpr std::chrono::milliseconds ShortestScan(100);

bool seesAnything(const Scan& scan) {
    return std::any_of(scan.points.begin(), scan.points.end(),
                       [](const Eigen::Vector3f& point) { return point.allFinite(); });
}

}  // namespace

ScanCutter::ScanCutter(std::string robot, const ScanCutterSettings& settings)
    : m_robot(std::move(robot)), m_settings(settings) {
    const TurnSettings turns{0.0, settings.longestWay, settings.mostTurned};
    m_row.assembler = m_late.assembler = TurnAssembler(turns);
}

void ScanCutter::add(const OdometrySample& odometry, Time now) {
    ++m_odometry;
    if (odometry.header.stamp == Time{}) {
        OdometrySample stamped = odometry;
        stamped.header.stamp = now;
        m_motion.add(stamped);
    } else {
        m_motion.add(odometry);
    }
    if (m_motion.clockJumps() != m_clockJumps) restart();
}

void ScanCutter::add(const ImuSample& imu, const Pose& unitInBase, Time now) {
    if (imu.header.stamp != Time{}) return m_motion.add(imu, unitInBase);
    ImuSample stamped = imu;
    stamped.header.stamp = now;
    m_motion.add(stamped, unitInBase);
}

void ScanCutter::add(CloudSample slice, const Pose& sensorInBase, Time now) {
    if (slice.header.stamp == Time{}) slice.header.stamp = now;
    const Time stamp = slice.header.stamp;
    const auto [first, last] = m_known.equal_range(stamp);
    if (std::any_of(first, last, [&](const auto& known) { return known.second == slice.header.frame; })) {
        ++m_doubled;
        return;
    }
    if (m_row.end && stamp < *m_row.end - LatestSlice) restart();
    m_known.emplace(stamp, slice.header.frame);
    while (m_known.begin()->first < stamp - Remembered) m_known.erase(m_known.begin());
    m_waiting.emplace(stamp, Waiting{std::move(slice), sensorInBase, now, m_odometry});
}

bool ScanCutter::ready(const Waiting& waiting, Time now) const {
    // A clock that was set back must not hold slices for ever.
    if (now - waiting.arrived >= m_settings.longestWait || now < waiting.arrived) return true;
    if (!m_motion.covers(endOf(waiting.slice))) return false;
    if (!m_row.end) return true;
    const Time stamp = waiting.slice.header.stamp;
    // A slice that is too old may be of a clock that was just set back. The next odometry shows it.
    if (stamp < *m_row.end - Seam) return m_odometry > waiting.odometry;
    return stamp - *m_row.end <= Seam;  // else the slice before may be on its way
}

std::vector<LiveScan> ScanCutter::take(Time now) {
    while (!m_waiting.empty() && ready(m_waiting.begin()->second, now)) {
        Waiting next = std::move(m_waiting.begin()->second);
        m_waiting.erase(m_waiting.begin());
        const bool late = m_row.end && next.slice.header.stamp < *m_row.end - Seam;
        put(std::move(next), late ? m_late : m_row);
    }
    if (m_late.assembler.gathers() && now - m_late.arrived > LateEnds) close(m_late);
    return std::exchange(m_done, {});
}

std::optional<Time> ScanCutter::due() const {
    if (!m_waiting.empty()) return m_waiting.begin()->second.arrived + m_settings.longestWait;
    if (m_late.assembler.gathers()) return m_late.arrived + LateEnds + std::chrono::milliseconds(1);
    return std::nullopt;
}

std::vector<LiveScan> ScanCutter::finish() {
    for (auto& [stamp, waiting] : std::exchange(m_waiting, {})) {
        const bool late = m_row.end && stamp < *m_row.end - Seam;
        put(std::move(waiting), late ? m_late : m_row);
    }
    close(m_late);
    close(m_row);
    return std::exchange(m_done, {});
}

void ScanCutter::put(Waiting waiting, Row& row) {
    const Time end = endOf(waiting.slice);
    const int frame = m_motion.frameAt(end);
    if (row.assembler.gathers() && frame != row.frame) close(row);
    row.frame = frame;
    row.sensorInBase = waiting.sensorInBase;
    row.arrived = waiting.arrived;
    row.end = row.end ? std::max(*row.end, end) : end;
    Parts parts;
    parts.slices = 1;
    const auto track = [&](Time at) -> std::optional<Pose> {
        const auto motion = m_motion.at(at);
        ++parts.poses;
        if (!motion) return std::nullopt;
        parts.guessed += motion->source == MotionSource::Extrapolated ? 1 : 0;
        parts.bridged = parts.bridged || motion->source == MotionSource::Bridged;
        return motion->baseInOdom * waiting.sensorInBase;
    };
    auto scan = row.assembler.add(std::move(waiting.slice), track);
    const TurnEnd ended = row.assembler.ended();
    if (scan && ended == TurnEnd::Sweep)
        return keep(std::move(scan), row, parts);  // beside the gathered slices
    // A break ends the turn before this slice.
    if (scan && ended == TurnEnd::Break)
        keep(std::exchange(scan, std::nullopt), row, std::exchange(row.parts, {}));
    row.parts.slices += parts.slices;
    row.parts.poses += parts.poses;
    row.parts.guessed += parts.guessed;
    row.parts.bridged = row.parts.bridged || parts.bridged;
    if (scan) keep(std::move(scan), row, std::exchange(row.parts, {}));
}

void ScanCutter::close(Row& row) {
    keep(row.assembler.finish(), row, std::exchange(row.parts, {}));
}

void ScanCutter::keep(std::optional<Scan> scan, const Row& row, const Parts& parts) {
    if (!scan || !seesAnything(*scan)) return;
    LiveScan live;
    live.end = row.assembler.ended();
    live.began = row.assembler.began();
    live.extrapolated = parts.guessed > 0;
    if (parts.poses > 0) live.guessed = static_cast<double>(parts.guessed) / parts.poses;
    live.bridged = parts.bridged;
    scan->robot = m_robot;
    live.sensorInBase = row.sensorInBase;
    live.odometryFrame = row.frame;
    live.plane = isPlaneScan(scan->points);
    live.slices = parts.slices;
    if (const auto up = m_motion.up(scan->end)) {
        live.up = row.sensorInBase.linear().transpose() * *up;
        live.levelKnown = live.levelByUnit = true;
    } else if (scan->hasOdometry) {
        live.up = scan->sensorInOdom.linear().transpose() * Eigen::Vector3d::UnitZ();
        live.levelKnown = !m_motion.hasUnit();
    }
    publishMotion(live, scan->start, scan->end);
    if (m_lastEnd) {
        const Travel travel = m_motion.travelled(*m_lastEnd, scan->end);
        live.way = travel.way;
        live.turn = travel.turn;
    }
    m_lastEnd = m_lastEnd ? std::max(*m_lastEnd, scan->end) : scan->end;
    live.scan = std::make_shared<const Scan>(std::move(*scan));
    m_done.push_back(std::move(live));
}

void ScanCutter::publishMotion(LiveScan& live, Time start, Time end) const {
    const Time since = std::min(start, end - ShortestScan);
    const auto before = m_motion.at(since), after = m_motion.at(end);
    if (!before || !after || m_motion.frameAt(since) != m_motion.frameAt(end)) return;
    const double time = toSeconds(end - since);
    const Eigen::Vector3d moved = (before->baseInOdom.inverse() * after->baseInOdom).translation();
    const double turn = headingOf(before->baseInOdom.linear().transpose() * after->baseInOdom.linear());
    live.velocity = Eigen::Rotation2Dd(-0.5 * turn) * Eigen::Vector2d(moved.head<2>()) / time;
    live.yawRate = turn / time;
    live.motionKnown = true;
}

void ScanCutter::restart() {
    m_clockJumps = m_motion.clockJumps();
    // Waiting slices may be of either time. Each is added by its stamp, when it is ready.
    close(m_late);
    close(m_row);
    m_row.end.reset();
    m_lastEnd.reset();
    m_known.clear();
}

}  // namespace leitstand
