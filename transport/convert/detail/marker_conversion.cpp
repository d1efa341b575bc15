#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "core/event/map_samples.h"
#include "core/event/picture_samples.h"
#include "messages/geometry_msgs.h"
#include "messages/vision_msgs.h"
#include "messages/visualization_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

using WireMarker = wire::visualization_msgs::Marker;

constexpr std::int32_t ArrowStrip = 12;                    ///< from Jazzy on
constexpr double ArrowLength = 0.5;                        ///< of a pose [m]
constexpr std::chrono::seconds Lifetime{5};                ///< of outlines and detections, sent steadily
constexpr double Thin = 0.03;                              ///< width of lines without any [m]
constexpr MarkerColour Drawn = {1.0F, 0.75F, 0.2F, 1.0F};  ///< of messages without colours
constexpr std::size_t LongestText = 200;                   ///< [B]

/// Types of visualization_msgs/msg/Marker by the shapes of MarkerShape. Lists of boxes and balls are boxes
/// and ellipsoids with points.
constexpr std::array Types = {
    WireMarker::ARROW_,        WireMarker::CUBE_,      WireMarker::SPHERE_, WireMarker::CYLINDER_,
    WireMarker::LINE_STRIP_,   WireMarker::LINE_LIST_, WireMarker::POINTS_, WireMarker::TEXT_VIEW_FACING_,
    WireMarker::TRIANGLE_LIST_};

MarkerShape shapeOf(std::int32_t type, Checks& checks) {
    if (type == WireMarker::CUBE_LIST_ || type == WireMarker::MESH_RESOURCE_) return MarkerShape::Box;
    if (type == WireMarker::SPHERE_LIST_) return MarkerShape::Ellipsoid;
    if (type == ArrowStrip) return MarkerShape::LineStrip;
    const auto* const found = std::find(Types.begin(), Types.end(), type);
    checks.require(found != Types.end(), "markers.type", "expected 0 to 12, found {}", type);
    return found == Types.end() ? MarkerShape::Box : static_cast<MarkerShape>(found - Types.begin());
}

float share(float value) {
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F;
}

MarkerColour colourOf(const wire::std_msgs::ColorRGBA& from) {
    return {share(from.r), share(from.g), share(from.b), share(from.a)};
}

std::string shortened(const std::string& text) {
    return text.substr(0, LongestText);
}

bool usesPoints(std::int32_t type) {
    return type != WireMarker::CUBE_ && type != WireMarker::SPHERE_ && type != WireMarker::CYLINDER_ &&
           type != WireMarker::TEXT_VIEW_FACING_ && type != WireMarker::MESH_RESOURCE_;
}

/// Checks that a place or a size is near enough to be drawn.
Eigen::Vector3d near(const char* field, const Eigen::Vector3d& place, Checks& checks) {
    constexpr double Farthest = 1e6;  // [m]
    checks.require(place.cwiseAbs().maxCoeff() <= Farthest, field, "expected at most {} m, found {}, {}, {}",
                   Farthest, place.x(), place.y(), place.z());
    return place;
}

/// Returns the marker that @p from adds.
Marker added(const WireMarker& from, Checks& checks) {
    Marker to;
    to.space = shortened(from.ns);
    to.id = from.id;
    to.header = checks.header(from.header);
    checks.require(from.action == WireMarker::ADD_, "markers.action", "expected 0, 2 or 3, found {}",
                   from.action);
    to.shape = shapeOf(from.type, checks);
    to.markerInFrame = checks.poseOrPlace("markers.pose", from.pose);
    (void)near("markers.pose", to.markerInFrame.translation(), checks);
    to.size = near("markers.scale", checks.vector("markers.scale", from.scale), checks);
    to.colour = colourOf(from.color);
    if (to.colour.a == 0.0F && !from.colors.empty()) to.colour = colourOf(from.colors.front());
    to.frameLocked = from.frame_locked;
    to.lifetime = checks.duration("markers.lifetime", from.lifetime);
    checks.require(to.lifetime.count() >= 0, "markers.lifetime", "expected no time before 0");
    if (usesPoints(from.type)) {
        to.points.reserve(from.points.size());
        for (const auto& point : from.points)
            to.points.push_back(near("markers.points", checks.vector("markers.points", point), checks));
    }
    if (to.shape == MarkerShape::Text) to.text = shortened(from.text);
    return to;
}

/// Checks what @p sample has in all.
void checkCounts(std::size_t markers, std::size_t points, Checks& checks) {
    checks.require(markers <= MarkersSample::MostMarkers, "markers", "expected at most {}, found {}",
                   MarkersSample::MostMarkers, markers);
    checks.require(points <= MarkersSample::MostPoints, "markers.points",
                   "expected at most {} in all, found {}", MarkersSample::MostPoints, points);
}

/// Takes @p all in their order. Those that make no sense are left out; if all are such, the first error is in
/// @p checks.
void take(MarkersSample& to, std::span<const WireMarker> all, Checks& checks) {
    std::optional<std::string> wrong;
    for (const WireMarker& from : all) {
        if (from.action == WireMarker::DELETEALL_) {
            to.replacesAll = true;
            to.markers.clear();
            continue;
        }
        if (from.action == WireMarker::DELETE_) {
            Marker& gone = to.markers.emplace_back();
            gone.space = shortened(from.ns);
            gone.id = from.id;
            gone.removed = true;
            continue;
        }
        Checks own;
        Marker marker = added(from, own);
        if (own.ok())
            to.markers.push_back(std::move(marker));
        else if (!wrong)
            wrong = own.error();
    }
    checks.require(!wrong || !to.markers.empty() || to.replacesAll, "markers", "{}", wrong.value_or(""));
}

/// Returns what a detector or a planner draws, under the number @p id.
Marker plain(const SampleHeader& header, std::int32_t id, MarkerShape shape) {
    Marker marker;
    marker.header = header;
    marker.id = id;
    marker.shape = shape;
    marker.colour = Drawn;
    return marker;
}

/// Returns the most likely one of @p results; null: there are none.
const wire::vision_msgs::ObjectHypothesis* likeliest(
    const std::vector<wire::vision_msgs::ObjectHypothesisWithPose>& results) {
    const auto best = std::max_element(results.begin(), results.end(), [](const auto& a, const auto& b) {
        return a.hypothesis.score < b.hypothesis.score;
    });
    return best == results.end() ? nullptr : &best->hypothesis;
}

Detection seenIn(const wire::vision_msgs::Detection2D& from, Checks& checks) {
    constexpr double Farthest = 1e6;  // [px]
    Detection to;
    to.centre = checks.vector2("bbox.center", from.bbox.center.position);
    to.turned = checks.finite("bbox.center.theta", from.bbox.center.theta);
    to.size = {checks.finite("bbox.size_x", from.bbox.size_x),
               checks.finite("bbox.size_y", from.bbox.size_y)};
    checks.require(to.centre.cwiseAbs().maxCoeff() <= Farthest && to.size.maxCoeff() <= Farthest &&
                       to.size.minCoeff() >= 0.0,
                   "bbox", "expected 0 to {} px", Farthest);
    if (const auto* const best = likeliest(from.results); best != nullptr) {
        to.label = shortened(best->class_id);
        if (std::isfinite(best->score)) to.score = best->score;
    }
    return to;
}

}  // namespace

MarkersSample fromWire(const wire::visualization_msgs::MarkerArray& from, const Source&, Checks& checks) {
    MarkersSample to;
    std::size_t points = 0;
    for (const WireMarker& one : from.markers) points += one.points.size();
    checkCounts(from.markers.size(), points, checks);
    if (!checks.ok()) return to;
    take(to, from.markers, checks);
    return to;
}

MarkersSample fromWire(const WireMarker& from, const Source&, Checks& checks) {
    MarkersSample to;
    checkCounts(1, from.points.size(), checks);
    if (checks.ok()) take(to, std::span(&from, 1), checks);
    return to;
}

void toWire(const MarkersSample& from, wire::visualization_msgs::MarkerArray& to, Buffer&, Checks& checks) {
    if (from.replacesAll) to.markers.emplace_back().action = WireMarker::DELETEALL_;
    for (const Marker& marker : from.markers) {
        WireMarker& one = to.markers.emplace_back();
        if (!marker.removed) one.header = checks.wireHeader(marker.header);
        one.ns = marker.space;
        one.id = marker.id;
        one.action = marker.removed ? WireMarker::DELETE_ : WireMarker::ADD_;
        if (marker.removed) continue;
        one.type = Types.at(static_cast<std::size_t>(marker.shape));
        if (!marker.points.empty() && marker.shape == MarkerShape::Box) one.type = WireMarker::CUBE_LIST_;
        if (!marker.points.empty() && marker.shape == MarkerShape::Ellipsoid)
            one.type = WireMarker::SPHERE_LIST_;
        one.pose = checks.wirePose("markers.pose", marker.markerInFrame);
        one.scale = checks.wireVector<wire::geometry_msgs::Vector3>("markers.scale", marker.size);
        one.color = {marker.colour.r, marker.colour.g, marker.colour.b, marker.colour.a};
        one.frame_locked = marker.frameLocked;
        one.lifetime = checks.wireDuration("markers.lifetime", marker.lifetime);
        for (const Eigen::Vector3d& point : marker.points)
            one.points.push_back(checks.wireVector<wire::geometry_msgs::Point>("markers.points", point));
        one.text = marker.text;
    }
}

/// An outline; each message replaces the one before.
MarkersSample fromWire(const wire::geometry_msgs::PolygonStamped& from, const Source&, Checks& checks) {
    MarkersSample to;
    to.replacesAll = true;
    checkCounts(1, from.polygon.points.size(), checks);
    if (!checks.ok() || from.polygon.points.empty()) return to;
    Marker outline = plain(checks.header(from.header), 0, MarkerShape::LineStrip);
    outline.size = {Thin, 0.0, 0.0};
    outline.lifetime = Lifetime;
    for (const auto& corner : from.polygon.points)
        outline.points.push_back(near("polygon.points", checks.vector("polygon.points", corner), checks));
    outline.points.push_back(outline.points.front());
    to.markers.push_back(std::move(outline));
    return to;
}

/// An arrow, and the ellipse in the plane in which the place lies with 86 % (2 standard deviations).
MarkersSample fromWire(const wire::geometry_msgs::PoseWithCovarianceStamped& from, const Source&,
                       Checks& checks) {
    constexpr std::size_t Row = 6;
    MarkersSample to;
    to.replacesAll = true;
    const SampleHeader header = checks.header(from.header);
    const Pose pose = checks.poseOrPlace("pose.pose", from.pose.pose);
    (void)near("pose.pose", pose.translation(), checks);
    Marker arrow = plain(header, 0, MarkerShape::Arrow);
    arrow.markerInFrame = pose;
    arrow.size = {ArrowLength, 0.1, 0.1};
    to.markers.push_back(std::move(arrow));
    const auto covariances = covariance(from.pose.covariance);
    Eigen::Matrix2d plane;
    plane << covariances[0], covariances[1], covariances[Row], covariances[Row + 1];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(0.5 * (plane + plane.transpose()));
    const Eigen::Vector2d radii = 2.0 * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    constexpr double Nobody = 1e3;  // [m]: larger doubts mean that nobody knows
    if (!(radii.maxCoeff() > 0.0 && radii.maxCoeff() < Nobody)) return to;
    Marker doubt = plain(header, 1, MarkerShape::Ellipsoid);
    // Position covariances are in the axes of the header's frame.
    const Eigen::Vector2d main = axes.eigenvectors().col(0);
    doubt.markerInFrame = poseFrom(pose.translation(), 0.0, 0.0, std::atan2(main.y(), main.x()));
    doubt.size = {2.0 * radii[0], 2.0 * radii[1], 0.0};
    to.markers.push_back(std::move(doubt));
    return to;
}

/// A box for each detection, with its best class and score; each message replaces the one before.
MarkersSample fromWire(const wire::vision_msgs::Detection3DArray& from, const Source&, Checks& checks) {
    MarkersSample to;
    to.replacesAll = true;
    checkCounts(2 * from.detections.size(), 0, checks);
    if (!checks.ok()) return to;
    std::int32_t id = 0;
    for (const auto& detection : from.detections) {
        const auto& header = detection.header.frame_id.empty() ? from.header : detection.header;
        Marker box = plain(checks.header(header), id++, MarkerShape::Box);
        box.markerInFrame = checks.poseOrPlace("detections.bbox.center", detection.bbox.center);
        (void)near("detections.bbox.center", box.markerInFrame.translation(), checks);
        box.size =
            near("detections.bbox.size", checks.vector("detections.bbox.size", detection.bbox.size), checks);
        box.lifetime = Lifetime;
        Marker label = plain(box.header, id++, MarkerShape::Text);
        label.markerInFrame = box.markerInFrame;
        label.lifetime = Lifetime;
        const auto* const best = likeliest(detection.results);
        to.markers.push_back(std::move(box));
        if (best == nullptr) continue;
        label.text = shortened(best->class_id);
        if (std::isfinite(best->score)) label.text += fmt::format(" {:.2f}", best->score);
        to.markers.push_back(std::move(label));
    }
    return to;
}

DetectionsSample fromWire(const wire::vision_msgs::Detection2DArray& from, const Source&, Checks& checks) {
    DetectionsSample to;
    to.header = checks.header(from.header);
    if (from.header.frame_id.empty() && !from.detections.empty())
        to.header = checks.header(from.detections.front().header);
    // A box that makes no sense is left out; if all are such, the message is refused.
    std::string wrong;
    for (const auto& detection : from.detections) {
        if (to.detections.size() >= DetectionsSample::Most) break;
        Checks own;
        Detection one = seenIn(detection, own);
        if (own.ok())
            to.detections.push_back(std::move(one));
        else if (wrong.empty())
            wrong = own.error();
    }
    checks.require(wrong.empty() || !to.detections.empty(), "detections", "{}", wrong);
    return to;
}

void toWire(const DetectionsSample& from, wire::vision_msgs::Detection2DArray& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    for (const Detection& one : from.detections) {
        auto& detection = to.detections.emplace_back();
        detection.header = to.header;
        detection.bbox.center.position = {one.centre.x(), one.centre.y()};
        detection.bbox.center.theta = one.turned;
        detection.bbox.size_x = one.size.x();
        detection.bbox.size_y = one.size.y();
        auto& result = detection.results.emplace_back();
        result.hypothesis.class_id = one.label;
        result.hypothesis.score = one.score;
        result.pose.pose.orientation.w = 1.0;
    }
}

std::vector<Conversion> markerConversions() {
    return {
        conversion<wire::visualization_msgs::MarkerArray, MarkersSample>(),
        decoding<WireMarker, MarkersSample>(),
        decoding<wire::geometry_msgs::PolygonStamped, MarkersSample>(),
        decoding<wire::geometry_msgs::PoseWithCovarianceStamped, MarkersSample>(),
        decoding<wire::vision_msgs::Detection3DArray, MarkersSample>(),
        conversion<wire::vision_msgs::Detection2DArray, DetectionsSample>(),
    };
}

}  // namespace leitstand::detail
