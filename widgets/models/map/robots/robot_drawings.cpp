#include "widgets/models/map/robots/robot_drawings.h"

#include <algorithm>
#include <cmath>

#include "core/base/rotation/heading.h"
#include "core/event/motion_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/robot/frame_names.h"
#include "core/robot/robot_description.h"
#include "core/station/robot_frames.h"
#include "widgets/models/map/robots/drawn_alike.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

using Eigen::Vector3d;

constexpr int Corners = 24;         // of a circle
constexpr double HeadShare = 0.25;  // length of an arrow's head

/// Returns where @p frame lies in the robot's base; empty: it does not, or nobody tells.
std::optional<Pose> placeInBase(const std::string& frame, const RobotDescription& robot,
                                const RobotState& reported) {
    const bool isBase = frame == frameName(robot, robot.baseFrame) ||
                        (reported.odometry && frame == reported.odometry->sample.childFrame);
    if (isBase) return Pose::Identity();
    for (const auto& [name, sensor] : robot.sensors) {
        // Without a place in the file, and for a camera that turns, only tf would tell.
        const bool known = !sensor.panTilt && !sensor.sensorInBase.isApprox(Pose::Identity());
        if (known && frameName(robot, sensor.frame) == frame) return sensor.sensorInBase;
    }
    return std::nullopt;
}

/// The unit circle, closed.
const std::vector<Eigen::Vector2d>& circle() {
    static const std::vector<Eigen::Vector2d> places = [] {
        std::vector<Eigen::Vector2d> all;
        for (int i = 0; i <= Corners; ++i) {
            const double angle = degrees(360.0 * i / Corners);
            all.emplace_back(std::cos(angle), std::sin(angle));
        }
        return all;
    }();
    return places;
}

/// Turns markers into lines, dots and texts.
class Drafting {
public:
    void add(const Marker& marker, const Pose& frame) {
        if (marker.colour.a <= 0.0F) return;  // so are markers hidden
        m_pose = frame * marker.markerInFrame;
        m_colour = marker.colour;
        const std::vector<Vector3d>& points = marker.points;
        switch (marker.shape) {
            case MarkerShape::Arrow:
                return arrow(marker);
            case MarkerShape::Box:
            case MarkerShape::Ellipsoid:
            case MarkerShape::Cylinder:
                if (points.empty()) return solid(marker, Vector3d::Zero());
                for (const Vector3d& middle : points)
                    if (!isFull()) solid(marker, middle);
                return;
            case MarkerShape::LineStrip:
                return line(points);
            case MarkerShape::LineList:
                for (std::size_t i = 1; i < points.size() && !isFull(); i += 2)
                    line({points[i - 1], points[i]});
                return;
            case MarkerShape::Points:
                return put(m_drawings.dots, points);
            case MarkerShape::Triangles:
                for (std::size_t i = 2; i < points.size() && !isFull(); i += 3)
                    line({points[i - 2], points[i - 1], points[i], points[i - 2]});
                return;
            case MarkerShape::Text:
                if (!marker.text.empty() && m_drawings.texts.size() < Drawings::MostTexts)
                    m_drawings.texts.push_back({m_pose.translation(), othersText(marker.text), m_colour});
        }
    }
    [[nodiscard]] Drawings take() { return std::move(m_drawings); }

private:
    void put(std::vector<Drawings::Line>& lines, std::vector<Vector3d> places) {
        places.resize(std::min(places.size(), Drawings::MostPlaces - m_places));
        if (places.empty()) return;
        m_places += places.size();
        for (Vector3d& place : places) place = m_pose * place;
        lines.push_back({std::move(places), m_colour});
    }
    [[nodiscard]] bool isFull() const { return m_places >= Drawings::MostPlaces; }
    void line(std::vector<Vector3d> places) { put(m_drawings.lines, std::move(places)); }

    void arrow(const Marker& marker) {
        const bool given = marker.points.size() >= 2;
        const Vector3d from = given ? marker.points[0] : Vector3d::Zero();
        const Vector3d to = given ? marker.points[1] : Vector3d(marker.size.x(), 0.0, 0.0);
        const Vector3d back = HeadShare * (from - to);
        Vector3d aside = back.cross(Vector3d::UnitZ());
        if (aside.norm() < 1e-6 * back.norm()) aside = Vector3d::UnitX();
        aside = 0.5 * back.norm() * aside.normalized();
        line({from, to});
        line({to + back + aside, to, to + back - aside});
    }

    void solid(const Marker& marker, const Vector3d& middle) {
        const Vector3d half = 0.5 * marker.size;
        if (marker.shape == MarkerShape::Box) return box(middle, half);
        const Vector3d x(half.x(), 0, 0), y(0, half.y(), 0), z(0, 0, half.z());
        if (marker.shape == MarkerShape::Ellipsoid) {
            ring(middle, x, y);
            if (half.z() > 0.0) {
                ring(middle, x, z);
                ring(middle, y, z);
            }
            return;
        }
        ring(middle + z, x, y);
        ring(middle - z, x, y);
        for (const Vector3d& side : {x, y, Vector3d(-x), Vector3d(-y)})
            line({middle + side - z, middle + side + z});
    }

    void box(const Vector3d& middle, const Vector3d& half) {
        const auto corner = [&](int i) {
            return Vector3d(middle + Vector3d((i & 1) != 0 ? half.x() : -half.x(),
                                              (i & 2) != 0 ? half.y() : -half.y(),
                                              (i & 4) != 0 ? half.z() : -half.z()));
        };
        line({corner(0), corner(1), corner(3), corner(2), corner(0)});
        line({corner(4), corner(5), corner(7), corner(6), corner(4)});
        for (int i = 0; i < 4; ++i) line({corner(i), corner(i + 4)});
    }

    void ring(const Vector3d& middle, const Vector3d& a, const Vector3d& b) {
        std::vector<Vector3d> places;
        for (const Eigen::Vector2d& at : circle()) places.emplace_back(middle + at.x() * a + at.y() * b);
        line(std::move(places));
    }

    Drawings m_drawings;
    Pose m_pose = Pose::Identity();
    MarkerColour m_colour;
    std::size_t m_places = 0;
};

}  // namespace

bool RobotDrawer::sameFrames(const Frames& frames) const {
    const auto same = [](const std::optional<Pose>& a, const std::optional<Pose>& b) {
        return a && b ? drawnAlike(*a, *b) : a.has_value() == b.has_value();
    };
    return std::equal(frames.begin(), frames.end(), m_frames.begin(), m_frames.end(),
                      [&](const auto& a, const auto& b) {
                          return a.first == b.first && same(a.second.inMap, b.second.inMap) &&
                                 same(a.second.inBase, b.second.inBase);
                      });
}

std::shared_ptr<const Drawings> RobotDrawer::at(const RobotDescription& robot, const RobotState& reported,
                                                const RobotInMap& place, Time now) {
    std::vector<LatestPtr<MarkerBoard>> boards;
    for (const auto& [topic, board] : reported.markers)
        if (board && !board->sample.drawn.empty()) boards.push_back(board);
    if (!place.placed || !reported.odometry) boards.clear();
    const auto placed = [&](const std::string& frame) {
        Placed found{{}, placeInBase(frame, robot, reported)};
        if (!found.inBase) found.inMap = frameInMap(frame, reported, place);
        return found;
    };
    const Pose odomInMap = place.odomInMap.value_or(
        reported.odometry ? place.baseInMap * reported.odometry->sample.baseInOdom.inverse()
                          : Pose::Identity());
    if (boards == m_boards) {
        Frames frames = m_frames;
        for (auto& [frame, where] : frames) where = placed(frame);
        const bool isOfThen = m_drafted && now >= *m_drafted && (!m_next || now <= *m_next);
        if (isOfThen && sameFrames(frames) && drawnAlike(odomInMap, m_odomInMap) &&
            (!m_locked || drawnAlike(place.baseInMap, m_baseInMap)))
            return m_drawings;
    }
    Frames frames;
    Drafting drafting;
    m_next.reset();
    m_locked = false;
    for (const LatestPtr<MarkerBoard>& board : boards) {
        for (const auto& [name, one] : board->sample.drawn) {
            if (isOver(one, now)) continue;
            const Marker& marker = *one.marker;
            if (marker.lifetime.count() > 0) {
                const Time over = one.received + marker.lifetime;
                m_next = m_next ? std::min(*m_next, over) : over;
            }
            auto frame = frames.find(marker.header.frame);
            if (frame == frames.end())
                frame = frames.emplace(marker.header.frame, placed(marker.header.frame)).first;
            const auto& [inMap, inBase] = frame->second;
            if (inMap) drafting.add(marker, *inMap);
            if (!inBase) continue;
            m_locked = m_locked || marker.frameLocked;
            const Pose base = marker.frameLocked ? place.baseInMap : Pose(odomInMap * one.baseInOdom);
            drafting.add(marker, base * *inBase);
        }
    }
    Drawings drawings = drafting.take();
    const bool none = drawings.lines.empty() && drawings.dots.empty() && drawings.texts.empty();
    m_boards = std::move(boards);
    m_frames = std::move(frames);
    m_baseInMap = place.baseInMap;
    m_odomInMap = odomInMap;
    m_drafted = now;
    m_drawings = none ? nullptr : std::make_shared<const Drawings>(std::move(drawings));
    return m_drawings;
}

}  // namespace leitstand
