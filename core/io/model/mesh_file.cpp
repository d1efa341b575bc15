#include "core/io/model/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include "core/io/detail/numbers.h"

namespace leitstand {
namespace {

constexpr std::uintmax_t LargestFile = 256U << 20U;  // [B]
constexpr std::array<std::string_view, 6> Endings = {".dae", ".stl", ".obj", ".ply", ".glb", ".gltf"};
const PartColour Textured(0.62F, 0.65F, 0.70F);

PartColour colourOf(const aiMaterial& material) {
    aiColor4D colour;
    const bool textured = material.GetTextureCount(aiTextureType_DIFFUSE) > 0;
    if (textured || material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) return Textured;
    PartColour rgb(colour.r, colour.g, colour.b);
    if (!rgb.allFinite()) return Textured;
    return rgb.cwiseMax(0.0F).cwiseMin(1.0F);
}

/// Adds @p from to @p mesh; false: it has a vertex that is no place, or too many triangles.
bool append(TriangleMesh& mesh, const aiMesh& from, const PartColour& colour) {
    constexpr float Farthest = 1e6F;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        const aiVector3D& at = from.mVertices[i];
        if (!(std::abs(at.x) < Farthest && std::abs(at.y) < Farthest && std::abs(at.z) < Farthest))
            return false;
        mesh.vertices.emplace_back(at.x, at.y, at.z);
    }
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        if (face.mNumIndices != 3) continue;
        const std::array<std::uint32_t, 3> corners = {first + face.mIndices[0], first + face.mIndices[1],
                                                      first + face.mIndices[2]};
        for (const std::uint32_t corner : corners)
            if (corner >= mesh.vertices.size()) return false;
        if (mesh.triangles.size() >= TriangleMesh::MostTriangles) return false;
        mesh.triangles.push_back(corners);
        mesh.colours.push_back(colour);
    }
    return true;
}

}  // namespace

Result<TriangleMesh> readMesh(const std::filesystem::path& file) {
    const std::string ending = detail::lowerCase(file.extension().string());
    if (std::find(Endings.begin(), Endings.end(), ending) == Endings.end())
        return Error{fmt::format("{}: expected a mesh as dae, stl, obj, ply, glb or gltf", file.string())};
    std::error_code problem;
    // A device or a pipe would never end.
    if (!std::filesystem::is_regular_file(file, problem))
        return Error{fmt::format("{}: expected a file", file.string())};
    if (const auto size = std::filesystem::file_size(file, problem); problem || size > LargestFile)
        return Error{fmt::format("{}: expected at most {} MB", file.string(), LargestFile >> 20U)};
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* const scene =
        importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                             aiProcess_PreTransformVertices | aiProcess_SortByPType);
    if (scene == nullptr)
        return Error{fmt::format("{}: expected a mesh ({})", file.string(), importer.GetErrorString())};
    TriangleMesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        const aiMesh& one = *scene->mMeshes[i];
        const PartColour colour = one.mMaterialIndex < scene->mNumMaterials
                                      ? colourOf(*scene->mMaterials[one.mMaterialIndex])
                                      : Textured;
        if (!append(mesh, one, colour))
            return Error{fmt::format("{}: expected at most {} triangles, within a million units",
                                     file.string(), TriangleMesh::MostTriangles)};
    }
    if (mesh.triangles.empty())
        return Error{fmt::format("{}: expected triangles, found none", file.string())};
    return mesh;
}

}  // namespace leitstand
