#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/robot/model/triangle_mesh.h"

namespace leitstand {

/// Reads the surface in a file of the kinds that robots' models name: Collada, STL, Wavefront OBJ, PLY, glTF.
/// Its axes are those of the file, as in RViz, lengths are scaled to metres where the file names its unit. A
/// texture counts as grey. The error has the file and what was expected.
[[nodiscard]] Result<TriangleMesh> readMesh(const std::filesystem::path& file);

}  // namespace leitstand
