#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/robot/model/robot_model.h"
#include "core/robot/model/triangle_mesh.h"

namespace leitstand {

/// The surface of one link, in the link's axes.
struct BodyPart {
    std::size_t link = 0;  ///< index of RobotModel::links
    TriangleMesh surface;
};

/// A robot's model with the surfaces of its links, as it is drawn. Immutable once shared.
struct ModelBody {
    /// Triangles that a body is drawn with at most.
    static constexpr std::size_t MostTriangles = 12'000;
    static constexpr double Farthest = 10.0;  ///< of its parts from the base, all joints at rest [m]

    RobotModel model;
    std::size_t base = 0;         ///< index of the link that is the robot's base frame
    std::vector<BodyPart> parts;  ///< links without a surface have none
    /// Whether each link that has something to show is drawn, if only with simple shapes.
    bool whole = true;
    std::vector<std::string> missing;  ///< why meshes are not drawn, one text per mesh
};
using ModelBodyPtr = std::shared_ptr<const ModelBody>;

/// Returns the mesh at @p uri, unscaled. The error says why there is none.
using MeshSource = std::function<Result<TriangleMesh>(const std::string& uri)>;

/// Returns the body of @p model. A link whose meshes are missing is drawn with the simple shapes of its
/// collision geometry, if it has any. @p baseFrame: the robot's base; the root if no link is called so.
[[nodiscard]] ModelBody bodyOf(RobotModel model, const std::string& baseFrame, const MeshSource& meshes);

/// Whether a part of @p body lies farther from its base than ModelBody::Farthest, all joints at rest.
[[nodiscard]] bool isTooLarge(const ModelBody& body);

/// What a body takes up when all joints are at rest.
struct BodyExtent {
    std::vector<Eigen::Vector2d>
        footprint;        ///< convex, counter-clockwise, at most 16 corners, in the base [m]
    double height = 0.0;  ///< of its highest point above its lowest [m]
};
/// Returns the extent of @p body, to the millimetre. Errors: it has no surface, is not whole, or is larger or
/// flatter than a robot's file may say.
[[nodiscard]] Result<BodyExtent> extentOf(const ModelBody& body);

}  // namespace leitstand
