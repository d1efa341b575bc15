#include "core/perception/surroundings/virtual_scan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/rotation/heading.h"
#include "core/base/time.h"
#include "core/event/cloud_sample.h"

namespace leitstand {
namespace {

constexpr double Pi = std::numbers::pi;
constexpr double SliceGap = 0.25;          // raw scans so close in time belong together [s]
constexpr double WidestStep = degrees(6);  // ... and in direction
constexpr double LowPoint = 0.15;          // points so low over the ground show it [m]
constexpr double NearBy = 1.5;             // obstacles so near are remembered separately [m]
constexpr double NearInPlane = 0.8;        // ... of plane scanners, which look only ahead [m]
constexpr std::size_t LookEvery = 3;       // every third of their rays looks through what is remembered
constexpr double Sunk = 0.03;              // distance from the plane of its wheels, beyond a step [m]
constexpr double SameSurface = 0.15;       // between neighbouring points of a surface that it stands on [m]
constexpr double Behind = 0.05;            // an obstacle's own points may lie so far before it [m]
constexpr auto SameLook = std::chrono::milliseconds(500);  // rays of one direction in this time are one look

double wrapped(double angle) {
    return std::remainder(angle, 2.0 * Pi);
}

Eigen::Vector2d flat(const Eigen::Vector3d& point) {
    return point.head<2>();
}

/// Whether the points of a row lie in one direction, as those of a vertical raw scan do; in base_link's axes.
bool isUpright(const CloudSample& cloud, std::size_t row, const Eigen::Matrix3d& toBase) {
    constexpr double Widest = 0.2;  // mean offset to the side, as a share of the distance
    const auto columns = static_cast<std::size_t>(cloud.columns);
    std::vector<Eigen::Vector2d> ways;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
        if (!cloud.points[i].allFinite() || cloud.points[i].squaredNorm() < 1e-6F) continue;
        ways.push_back(flat(toBase * cloud.points[i].cast<double>().normalized()));
        sum += ways.back();
    }
    if (ways.empty() || sum.norm() < 1e-9) return true;
    const Eigen::Vector2d middle = sum.normalized();
    double aside = 0.0;
    for (const Eigen::Vector2d& way : ways) aside += std::abs(middle.x() * way.y() - middle.y() * way.x());
    return aside / static_cast<double>(ways.size()) < Widest;
}

/// Whether rows are vertical raw scans: most of them, as far as they have echoes.
bool hasUprightRows(const CloudSample& cloud, const Eigen::Matrix3d& toBase) {
    const auto rows = static_cast<std::size_t>(cloud.rows);
    if (cloud.points.size() < rows * static_cast<std::size_t>(cloud.columns)) return true;
    std::size_t upright = 0;
    for (std::size_t row = 0; row < rows; ++row) upright += isUpright(cloud, row, toBase) ? 1 : 0;
    return 2 * upright > rows;
}

/// Whether an echo of a plane scanner has another one beside it, and is no mixed pixel at an edge.
bool isSupported(const RangesSample& ranges, std::size_t ray, const ProfileSettings& profile) {
    const double range = static_cast<double>(ranges.ranges[ray]);
    const double near = profile.support + profile.supportRate * range;
    const auto supports = [&](std::size_t other) {
        return other < ranges.ranges.size() &&
               std::abs(static_cast<double>(ranges.ranges[other]) - range) < near;
    };
    return supports(ray + 1) || (ray > 0 && supports(ray - 1));
}

/// A point of a raw scan before sorting.
struct Measured {
    Eigen::Vector3d inOdom;
    double elevation = 0.0;  ///< from the scanner [rad]
};

}  // namespace

VirtualScan::VirtualScan(const VirtualScanSettings& settings)
    : m_settings(settings), m_rays(static_cast<std::size_t>(std::max(8, settings.sectors))) {}

void VirtualScan::clear() {
    std::fill(m_rays.begin(), m_rays.end(), Ray{});
    m_ownBody.clear();
    m_near.clear();
    m_before.reset();
    m_newest.reset();
}

bool VirtualScan::isOwn(const Eigen::Vector3d& inBase) const {
    return inBase.z() < m_settings.profile.height + m_settings.bodyMargin &&
           m_settings.body.grown(m_settings.bodyMargin).contains(flat(inBase));
}

int VirtualScan::binOf(double heading) const {
    const int count = static_cast<int>(m_rays.size());
    const int bin = static_cast<int>(std::floor((wrapped(heading) + Pi) / (2.0 * Pi) * count));
    return std::clamp(bin, 0, count - 1);
}

void VirtualScan::add(const CloudSample& cloud, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom) {
    const auto timeOf = [&cloud](std::size_t i) {
        return cloud.times.empty() ? cloud.header.stamp
                                   : cloud.header.stamp + std::chrono::nanoseconds(cloud.times[i]);
    };
    // Before mixed points are judged: in the first turn nothing else shows where the body is.
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        if (cloud.points[i].squaredNorm() < 1e-6F) continue;  // no echo
        const Eigen::Vector3d inBase = sensorInBase * cloud.points[i].cast<double>();
        // Below the step it is floor beside the robot.
        if (isOwn(inBase) && inBase.z() > m_settings.profile.step)
            m_ownBody.add(inBase - sensorInBase.translation(), timeOf(i));
    }
    std::optional<Pose> newest;  // base_link in odom
    /// Brings the points of one raw scan, @p indices, into the odometry's frame and adds them as of @p at.
    const auto addRaw = [&](const std::vector<std::size_t>& indices, Time at) {
        const auto base = baseInOdom(at);
        if (!base || !base->matrix().allFinite()) return;
        newest = base;
        const Eigen::Vector3d scanner = *base * sensorInBase.translation();
        std::vector<Measured> measured;
        measured.reserve(indices.size());
        for (const std::size_t i : indices) {
            const Eigen::Vector3f& point = cloud.points[i];
            if (!point.allFinite() || point.squaredNorm() < 1e-6F) continue;
            const Eigen::Vector3d inBase = sensorInBase * point.cast<double>();
            const Eigen::Vector3d shot = inBase - sensorInBase.translation();
            if (isOwn(inBase) || shot.norm() > m_settings.range) continue;
            if (shot.norm() < m_settings.mixedWithin && m_ownBody.isNear(shot, at)) continue;
            const Eigen::Vector3d inOdom = *base * inBase;
            const Eigen::Vector3d seen = inOdom - scanner;
            measured.push_back({inOdom, std::atan2(seen.z(), flat(seen).norm())});
        }
        std::stable_sort(measured.begin(), measured.end(),
                         [](const Measured& a, const Measured& b) { return a.elevation < b.elevation; });
        std::vector<ProfilePoint> points;
        points.reserve(measured.size());
        for (const Measured& one : measured) {
            points.push_back({flat(one.inOdom - scanner).norm(), one.inOdom.z() - base->translation().z(),
                              flat(one.inOdom)});
        }
        addProfile(std::move(points), *base, scanner, at);
    };

    if (cloud.organised() && hasUprightRows(cloud, sensorInBase.linear())) {
        const auto columns = static_cast<std::size_t>(cloud.columns);
        for (std::size_t row = 0; row < static_cast<std::size_t>(cloud.rows); ++row) {
            std::vector<std::size_t> indices(columns);
            for (std::size_t k = 0; k < columns; ++k) indices[k] = row * columns + k;
            if (indices.back() < cloud.points.size()) addRaw(indices, timeOf(indices.front()));
        }
        m_near.forgetMixed(m_ownBody, m_settings.mixedWithin);
        if (newest) forgetClimbed(*newest);
        return;
    }
    std::vector<std::vector<std::size_t>> raws(m_rays.size());
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        const Eigen::Vector3d point = sensorInBase.linear() * cloud.points[i].cast<double>();
        if (!point.allFinite()) continue;
        raws[static_cast<std::size_t>(binOf(std::atan2(point.y(), point.x())))].push_back(i);
    }
    // A tilting sweep sees a direction again and again: the last look counts.
    for (const auto& indices : raws) {
        if (!indices.empty()) addRaw(indices, timeOf(indices.back()));
    }
    m_near.forgetMixed(m_ownBody, m_settings.mixedWithin);
    if (newest) forgetClimbed(*newest);
}

void VirtualScan::addProfile(std::vector<ProfilePoint> points, const Pose& base,
                             const Eigen::Vector3d& scanner, Time at) {
    const Eigen::Vector2d origin = flat(scanner);
    // The farther points give the direction of a raw scan: near the axis directions are noise.
    Eigen::Vector2d towards = Eigen::Vector2d::Zero();
    for (const ProfilePoint& point : points) towards += point.where - origin;
    if (towards.norm() < 1e-3) return;
    const double heading = std::atan2(towards.y(), towards.x());
    // The last raw scan of a turn is sent again as the first of the next: it is no neighbour of itself.
    constexpr double SameHeading = 1e-3;
    if (m_before && m_before->at == at && std::abs(wrapped(heading - m_before->heading)) < SameHeading)
        return;
    const bool follows = m_before && std::abs(secondsBetween(m_before->at, at)) < SliceGap &&
                         std::abs(wrapped(heading - m_before->heading)) < WidestStep;
    const std::span<const ProfilePoint> neighbour =
        follows ? std::span<const ProfilePoint>(m_before->points) : std::span<const ProfilePoint>();
    const ProfileContour contour = contourOf(points, neighbour, m_settings.profile);

    Ray ray;
    ray.seen = true;
    ray.at = at;
    ray.echo = contour.outer.has_value();
    ray.far =
        ray.echo ? contour.outer->where : Eigen::Vector2d(origin + towards.normalized() * m_settings.range);
    if (contour.inner) {
        ray.inner = contour.inner->where;
        ray.top = contour.innerTop;
        ray.bottom = contour.innerBottom;
        ray.innerRise = contour.inner->height;
        ray.innerZ = base.translation().z() + ray.innerRise;
    }
    remember(points, ray, origin, heading);
    if (contour.inner && contour.inner->distance < NearBy) {
        const double height = base.translation().z() + contour.inner->height - scanner.z();
        const Eigen::Vector2d away = contour.inner->where - origin;
        const Eigen::Vector3d shot = base.linear().transpose() * Eigen::Vector3d(away.x(), away.y(), height);
        m_near.add({*ray.inner, ray.top, at, shot, ray.bottom, ray.innerZ, ray.innerRise});
    }
    const Time look = at - SameLook;
    if (follows) clearBetween(m_before->heading, heading, look);
    put(ray, heading, look);
    m_before = Before{std::move(points), heading, at};
}

void VirtualScan::remember(std::span<const ProfilePoint> points, const Ray& ray,
                           const Eigen::Vector2d& origin, double heading) {
    // The robot itself hides the ground beside it: what is nearer than the nearest visible ground stays.
    double nearest = std::numeric_limits<double>::infinity();
    for (const ProfilePoint& point : points) {
        if (point.height < LowPoint) nearest = std::min(nearest, point.distance);
    }
    const double farthest = ray.inner ? (*ray.inner - origin).norm() - Behind : (ray.far - origin).norm();
    m_near.lookThrough(origin, heading, nearest, farthest, ray.at);
}

void VirtualScan::put(const Ray& ray, double heading, Time look) {
    m_newest = m_newest ? std::max(*m_newest, ray.at) : ray.at;
    Ray& old = m_rays[static_cast<std::size_t>(binOf(heading))];
    if (old.seen && old.at > ray.at + std::chrono::milliseconds(500)) return;  // it comes late
    if (!old.seen || old.at < look) {
        old = ray;
        return;
    }
    // Of one look, the nearer obstacle and the farther wall count.
    const auto toFar = (ray.far - old.far).dot(Eigen::Vector2d(std::cos(heading), std::sin(heading)));
    if (toFar > 0.0 || (ray.echo && !old.echo)) {
        old.far = ray.far;
        old.echo = ray.echo;
    }
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    if (ray.inner && (!old.inner || direction.dot(*ray.inner - *old.inner) < 0.0)) {
        old.inner = ray.inner;
        old.top = ray.top;
        old.bottom = ray.bottom;
        old.innerZ = ray.innerZ;
        old.innerRise = ray.innerRise;
    }
    old.at = std::max(old.at, ray.at);
}

void VirtualScan::clearBetween(double from, double to, Time look) {
    const int count = static_cast<int>(m_rays.size());
    const int first = binOf(from), last = binOf(to);
    const int step = wrapped(to - from) >= 0.0 ? 1 : -1;
    for (int bin = first; bin != last; bin = (bin + step + count) % count) {
        Ray& ray = m_rays[static_cast<std::size_t>(bin)];
        if (bin != first && ray.seen && ray.at < look) ray = Ray{};
    }
}

void VirtualScan::add(const RangesSample& ranges, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom) {
    const BodyBox body = m_settings.body.grown(m_settings.bodyMargin);
    const double farthest =
        std::min(ranges.rangeMax > 0.0 ? ranges.rangeMax : m_settings.range, m_settings.range);
    double before = std::numeric_limits<double>::quiet_NaN();  // heading of the ray before
    std::optional<Pose> base;
    Time baseAt{};
    for (std::size_t i = 0; i < ranges.ranges.size(); ++i) {
        const auto number = static_cast<double>(i);
        const Time at = ranges.header.stamp +
                        std::chrono::nanoseconds(static_cast<std::int64_t>(number * ranges.timeStep * 1e9));
        if (!base || at - baseAt >= std::chrono::milliseconds(5)) {
            base = baseInOdom(at);
            baseAt = at;
        }
        if (!base || !base->matrix().allFinite()) continue;
        const double angle = ranges.angleMin + number * ranges.angleStep;
        const Eigen::Vector3d direction =
            sensorInBase.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
        const double range = static_cast<double>(ranges.ranges[i]);
        const bool echo = std::isfinite(range) && range >= ranges.rangeMin && range < farthest && range > 0.0;
        // Too near to measure, or absorbed: nothing is known of that direction.
        if (!echo && (std::isnan(range) || range < ranges.rangeMin)) {
            before = std::numeric_limits<double>::quiet_NaN();
            continue;
        }
        const Eigen::Vector3d inBase = sensorInBase.translation() + (echo ? range : farthest) * direction;
        if (echo && body.contains(flat(inBase))) continue;
        const Eigen::Vector3d inOdom = *base * inBase;
        const Eigen::Vector3d scanner = *base * sensorInBase.translation();
        const double height = inOdom.z() - base->translation().z();
        const double heading = std::atan2(inOdom.y() - scanner.y(), inOdom.x() - scanner.x());
        Ray ray;
        ray.seen = true;
        ray.at = at;
        ray.echo = echo && height < m_settings.profile.wallHeight;
        ray.far = flat(inOdom);
        const bool floor = height < m_settings.profile.step;
        if (echo && !floor && height < m_settings.profile.height &&
            isSupported(ranges, i, m_settings.profile))
            ray.inner = flat(inOdom), ray.innerZ = inOdom.z(), ray.innerRise = height;
        if (std::abs(wrapped(heading - before)) < WidestStep)
            clearBetween(before, heading, ranges.header.stamp);
        const double away = (ray.far - flat(scanner)).norm();
        if (i % LookEvery == 0)
            m_near.lookThrough(flat(scanner), heading, 0.0, echo ? away - Behind : away, at);
        if (ray.inner && away < NearInPlane)
            m_near.add({*ray.inner, ray.top, at, Eigen::Vector3d::Zero(), ray.bottom, ray.innerZ, height});
        put(ray, heading, ranges.header.stamp);
        before = heading;
    }
    if (base) forgetClimbed(*base);
}

void VirtualScan::forgetClimbed(const Pose& base) {
    const Pose odomInBase = base.inverse();
    std::vector<Eigen::Vector3d> climbed, level;  // in base_link
    const BodyBox about = m_settings.body.grown(SameSurface);
    const auto look = [&](const Eigen::Vector2d& where, double z, double rise) {
        const Eigen::Vector3d inBase = odomInBase * Eigen::Vector3d(where.x(), where.y(), z);
        const bool inPlane = std::abs(inBase.z()) <= m_settings.profile.step + Sunk;
        // An object on level ground is as high over it as before.
        if (!inPlane || inBase.z() > 0.5 * rise || flat(inBase).norm() > NearBy) return;
        (about.contains(flat(inBase)) ? climbed : level).push_back(inBase);
    };
    for (const Ray& ray : m_rays) {
        if (ray.seen && ray.inner) look(*ray.inner, ray.innerZ, ray.innerRise);
    }
    for (const NearObstacles::One& one : m_near.all()) look(one.where, one.z, one.rise);
    if (climbed.empty()) return;
    // Points that continue from there in the plane of the robot's wheels are of the same surface.
    for (std::size_t next = 0; next < climbed.size(); ++next) {
        const Eigen::Vector3d here = climbed[next];
        const auto on = std::partition(level.begin(), level.end(), [&](const Eigen::Vector3d& point) {
            return (flat(point) - flat(here)).norm() > SameSurface;
        });
        climbed.insert(climbed.end(), on, level.end());
        level.erase(on, level.end());
    }
    const auto isClimbed = [&](const Eigen::Vector2d& where, double z) {
        const Eigen::Vector3d inBase = odomInBase * Eigen::Vector3d(where.x(), where.y(), z);
        return std::find(climbed.begin(), climbed.end(), inBase) != climbed.end();
    };
    for (Ray& ray : m_rays) {
        if (ray.inner && isClimbed(*ray.inner, ray.innerZ)) ray.inner.reset();
    }
    m_near.forgetWhere([&](const NearObstacles::One& one) { return isClimbed(one.where, one.z); });
}

void VirtualScan::addObstacle(VirtualScanView& view, const VirtualObstacle& one) {
    view.obstacles.push_back(one);
    VirtualSector& holder =
        view.sectors[static_cast<std::size_t>(view.sectorOf(std::atan2(one.where.y(), one.where.x())))];
    if (!std::isfinite(holder.age)) holder.age = one.age;
    if (!holder.inner || one.where.norm() < holder.inner->norm()) holder.inner = one.where;
}

VirtualScanView VirtualScan::view(const Pose& baseInOdom, Time now) const {
    const double yaw = headingOf(baseInOdom);
    const Eigen::Rotation2Dd toBase(-yaw);
    const Eigen::Vector2d here = flat(baseInOdom.translation());
    VirtualScanView view;
    view.at = now;
    view.sectors.resize(m_rays.size());
    for (const Ray& ray : m_rays) {
        if (!ray.seen) continue;
        const double age = std::max(0.0, secondsBetween(ray.at, now));
        if (age > m_settings.memory) continue;
        const Eigen::Vector2d far = toBase * (ray.far - here);
        VirtualSector& sector =
            view.sectors[static_cast<std::size_t>(view.sectorOf(std::atan2(far.y(), far.x())))];
        sector.age = std::min(sector.age, age);
        if (ray.echo && (!sector.outer || far.norm() > sector.outer->norm())) sector.outer = far;
        if (ray.inner) addObstacle(view, {toBase * (*ray.inner - here), age, ray.top, ray.bottom});
    }
    for (const NearObstacles::One& one : m_near.all()) {
        const double age = std::max(0.0, secondsBetween(one.at, now));
        if (age > toSeconds(SameLook))
            addObstacle(view, {toBase * (one.where - here), age, one.top, one.bottom});
    }
    view.closeGaps();
    return view;
}

}  // namespace leitstand
