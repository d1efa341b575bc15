#include "core/io/handin/octomap_file.h"

#include <cmath>
#include <exception>
#include <fstream>
#include <sstream>
#include <string>

#include <octomap/OcTree.h>
#include <octomap/octomap.h>

#include "core/base/words.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

Result<void> writeOctomap(const std::filesystem::path& file, const VoxelEvidence& evidence) {
    octomap::OcTree tree(evidence.cell());
    const auto occupied = tree.getClampingThresMaxLog(), free = tree.getClampingThresMinLog();
    // Keys count cubes from the middle of a tree with 16 levels.
    constexpr int Middle = 32768;
    const Eigen::Vector3i first = evidence.first().array() + Middle;
    if ((first.array() < 0).any() || ((first + evidence.size()).array() > 2 * Middle).any())
        return Error{leitstand::fill(
            translate("leitstand::Error",
                      "{}: is not written: the map is too far from its origin for an OctoMap"),
            file.string())};
    for (int y = 0; y < evidence.size().y(); ++y) {
        for (int x = 0; x < evidence.size().x(); ++x) {
            for (int z = 0; z < evidence.size().z(); ++z) {
                const int value = evidence.at(x, y, z);
                if (value == 0) continue;
                const octomap::OcTreeKey key(static_cast<octomap::key_type>(first.x() + x),
                                             static_cast<octomap::key_type>(first.y() + y),
                                             static_cast<octomap::key_type>(first.z() + z));
                tree.setNodeValue(key, value > 0 ? occupied : free, true);
            }
        }
    }
    tree.updateInnerOccupancy();
    tree.prune();
    std::ostringstream bytes;
    if (!tree.writeBinaryConst(bytes))
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be written as an OctoMap"),
                                     file.string())};
    return detail::writeWhole(file, bytes.str());
}

Result<OctomapSummary> readOctomap(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened"), file.string())};
    std::string first;
    std::getline(in, first);
    if (!first.starts_with("# Octomap OcTree binary file"))
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected \"# Octomap OcTree binary file\" in its first line"),
            file.string())};
    in.clear();
    in.seekg(0);
    try {
        octomap::OcTree tree(0.1);
        if (!tree.readBinary(in) || !in || tree.getResolution() <= 0.0)
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: cannot be read as an OctoMap: expected a whole tree"),
                file.string())};
        OctomapSummary summary;
        summary.cell = tree.getResolution();
        summary.nodes = tree.size();
        for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
            (tree.isNodeOccupied(*leaf) ? summary.occupied : summary.free) += std::pow(leaf.getSize(), 3);
        }
        return summary;
    } catch (const std::exception& problem) {
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be read as an OctoMap: {}"),
                                     file.string(), problem.what())};
    }
}

}  // namespace leitstand
