#include "core/robot/model/model_body.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace leitstand {
namespace {

const PartColour Plain(0.62F, 0.65F, 0.70F);  ///< of parts without a colour

void append(TriangleMesh& to, const TriangleMesh& from, const Pose& fromInTo, const Eigen::Vector3d& scale) {
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    for (const Eigen::Vector3f& vertex : from.vertices)
        to.vertices.emplace_back((fromInTo * scale.cwiseProduct(vertex.cast<double>())).cast<float>());
    // A mirrored mesh is inside out.
    const bool turned = scale.prod() < 0.0;
    for (const auto& [a, b, c] : from.triangles)
        to.triangles.push_back({first + a, first + (turned ? c : b), first + (turned ? b : c)});
    to.colours.insert(to.colours.end(), from.colours.begin(), from.colours.end());
}

/// Makes the surfaces of links. Each mesh is read once.
class Surfaces {
public:
    explicit Surfaces(const MeshSource& meshes) : m_meshes(meshes) {}

    /// Adds @p part; false: its mesh is missing.
    bool add(TriangleMesh& surface, const LinkPart& part) {
        const auto* const mesh = std::get_if<MeshShape>(&part.shape);
        if (mesh == nullptr) {
            append(surface, surfaceOf(part.shape, part.colour.value_or(Plain)), part.partInLink,
                   Eigen::Vector3d::Ones());
            return true;
        }
        const TriangleMesh* const read = meshAt(mesh->uri);
        if (read == nullptr) return false;
        const std::size_t before = surface.colours.size();
        append(surface, *read, part.partInLink, mesh->scale);
        if (part.colour)
            std::fill(surface.colours.begin() + static_cast<std::ptrdiff_t>(before), surface.colours.end(),
                      *part.colour);
        return true;
    }
    [[nodiscard]] std::vector<std::string> missing() && { return std::move(m_missing); }

private:
    const TriangleMesh* meshAt(const std::string& uri) {
        const auto [found, isNew] = m_read.try_emplace(uri);
        if (isNew) {
            auto mesh = m_meshes(uri);
            if (mesh)
                found->second = reduced(std::move(mesh).value(), ModelBody::MostTriangles);
            else
                m_missing.push_back(mesh.error().text);
        }
        return found->second ? &*found->second : nullptr;
    }

    const MeshSource& m_meshes;
    std::map<std::string, std::optional<TriangleMesh>> m_read;
    std::vector<std::string> m_missing;
};

/// Keeps what was put together so far small, however many parts follow.
void bound(TriangleMesh& surface) {
    if (surface.triangles.size() > 4 * ModelBody::MostTriangles)
        surface = reduced(std::move(surface), ModelBody::MostTriangles);
}

TriangleMesh surfaceOf(const ModelLink& link, Surfaces& surfaces) {
    TriangleMesh surface;
    bool whole = true;
    for (const LinkPart& part : link.visuals) {
        whole = surfaces.add(surface, part) && whole;
        bound(surface);
    }
    if (whole) return surface;
    TriangleMesh simple;
    for (const LinkPart& part : link.collisions) {
        if (!std::holds_alternative<MeshShape>(part.shape)) surfaces.add(simple, part);
        bound(simple);
    }
    return simple.triangles.empty() ? surface : simple;
}

std::size_t trianglesOf(const std::vector<BodyPart>& parts) {
    std::size_t count = 0;
    for (const BodyPart& part : parts) count += part.surface.triangles.size();
    return count;
}

/// Reduces @p parts so that they have @p most triangles together. Small parts stay as they are; what they
/// leave of the budget is shared among the larger ones.
void reduceAll(std::vector<BodyPart>& parts, std::size_t most) {
    if (trianglesOf(parts) <= most) return;
    std::vector<BodyPart*> bySize;
    bySize.reserve(parts.size());
    for (BodyPart& part : parts) bySize.push_back(&part);
    std::sort(bySize.begin(), bySize.end(), [](const BodyPart* a, const BodyPart* b) {
        return a->surface.triangles.size() < b->surface.triangles.size();
    });
    std::size_t left = most;
    for (std::size_t i = 0; i < bySize.size(); ++i) {
        TriangleMesh& surface = bySize[i]->surface;
        surface = reduced(std::move(surface), left / (bySize.size() - i));
        left -= surface.triangles.size();
    }
}

double cross(const Eigen::Vector2d& from, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - from).x() * (b - from).y() - (a - from).y() * (b - from).x();
}

/// Returns the convex hull of @p points, counter-clockwise.
std::vector<Eigen::Vector2d> hullOf(const std::vector<Eigen::Vector2d>& points) {
    std::vector<cv::Point2f> all, corners;
    all.reserve(points.size());
    for (const Eigen::Vector2d& point : points)
        all.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
    if (!all.empty()) cv::convexHull(all, corners);
    std::vector<Eigen::Vector2d> hull;
    hull.reserve(corners.size());
    for (const cv::Point2f& corner : corners) hull.emplace_back(corner.x, corner.y);
    return hull;
}

/// Removes corners of the convex @p hull until it has @p most. Each time, one side is removed: its neighbours
/// grow until they meet. It is the side whose removal adds the least area; the outline never shrinks.
std::vector<Eigen::Vector2d> simplified(std::vector<Eigen::Vector2d> hull, std::size_t most) {
    const auto at = [&](std::size_t i) -> Eigen::Vector2d& { return hull[i % hull.size()]; };
    while (hull.size() > most) {
        std::size_t best = hull.size();
        double least = 0.0;
        Eigen::Vector2d corner = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < hull.size(); ++i) {
            // The side from i + 1 to i + 2 goes; those before and after it are made longer until they meet.
            const Eigen::Vector2d &a = at(i), &b = at(i + 1), &c = at(i + 2), &d = at(i + 3);
            const Eigen::Vector2d before = b - a, after = c - d;
            const double turn = before.x() * after.y() - before.y() * after.x();
            if (turn >= -1e-12) continue;  // they meet on the other side, or nowhere
            const Eigen::Vector2d gap = c - b;
            const double along = (gap.x() * after.y() - gap.y() * after.x()) / turn;
            if (along < 0.0) continue;
            const Eigen::Vector2d meeting = b + along * before;
            const double added = 0.5 * std::abs(cross(b, meeting, c));
            if (best == hull.size() || added < least) {
                best = i;
                least = added;
                corner = meeting;
            }
        }
        if (best == hull.size()) break;
        at(best + 1) = corner;
        hull.erase(hull.begin() + static_cast<std::ptrdiff_t>((best + 2) % hull.size()));
    }
    return hull;
}

}  // namespace

ModelBody bodyOf(RobotModel model, const std::string& baseFrame, const MeshSource& meshes) {
    ModelBody body;
    Surfaces surfaces(meshes);
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        TriangleMesh surface = surfaceOf(model.links[i], surfaces);
        body.whole = body.whole && (!surface.triangles.empty() || model.links[i].visuals.empty());
        if (surface.triangles.empty()) continue;
        triangles += surface.triangles.size();
        body.parts.push_back({i, std::move(surface)});
        if (triangles <= 10 * ModelBody::MostTriangles) continue;
        reduceAll(body.parts, ModelBody::MostTriangles);
        triangles = trianglesOf(body.parts);
    }
    reduceAll(body.parts, ModelBody::MostTriangles);
    body.base = model.linkAt(baseFrame).value_or(model.root);
    body.model = std::move(model);
    body.missing = std::move(surfaces).missing();
    return body;
}

bool isTooLarge(const ModelBody& body) {
    const auto poses = linksInBase(body.model, body.base, [](const std::string&) { return std::nullopt; });
    for (const BodyPart& part : body.parts) {
        for (const Eigen::Vector3f& vertex : part.surface.vertices) {
            const Eigen::Vector3d inBase = poses[part.link] * vertex.cast<double>();
            // Written so that what is no number is too large.
            if (!(inBase.cwiseAbs().maxCoeff() <= ModelBody::Farthest)) return true;
        }
    }
    return false;
}

Result<BodyExtent> extentOf(const ModelBody& body) {
    constexpr std::size_t MostCorners = 16;
    constexpr double Millimetres = 1e3, Flattest = 0.01;  // [m], as in robots' files
    if (!body.whole)
        return Error{"parts of the robot's model are meshes that are not here: its size is not known"};
    const auto poses = linksInBase(body.model, body.base, [](const std::string&) { return std::nullopt; });
    const auto rounded = [&](const std::vector<Eigen::Vector2d>& corners) {
        std::vector<Eigen::Vector2d> result;
        result.reserve(corners.size());
        for (const Eigen::Vector2d& corner : corners)
            result.emplace_back((Millimetres * corner).array().round() / Millimetres);
        return result;
    };
    std::vector<Eigen::Vector2d> seen;
    double lowest = 0.0, highest = 0.0;
    for (const BodyPart& part : body.parts) {
        for (const Eigen::Vector3f& vertex : part.surface.vertices) {
            const Eigen::Vector3d inBase = poses[part.link] * vertex.cast<double>();
            lowest = seen.empty() ? inBase.z() : std::min(lowest, inBase.z());
            highest = seen.empty() ? inBase.z() : std::max(highest, inBase.z());
            seen.emplace_back(inBase.head<2>());
        }
    }
    BodyExtent extent;
    if (isTooLarge(body))
        return Error{"the robot's model reaches farther than 10 m from its base: expected metres"};
    // Corners that are the same when they are written are one.
    if (seen.size() >= 3) extent.footprint = rounded(hullOf(rounded(simplified(hullOf(seen), MostCorners))));
    extent.height = std::round(Millimetres * (highest - lowest)) / Millimetres;
    if (extent.footprint.size() < 3) return Error{"the robot's model has no surface"};
    if (extent.height < Flattest) return Error{"the robot's model is flatter than 1 cm"};
    return extent;
}

}  // namespace leitstand
