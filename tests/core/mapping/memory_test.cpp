#include <cstdio>

#include <gtest/gtest.h>

#include "core/mapping/scan_preparation.h"
#include "tests/support/rooms.h"

namespace leitstand {
namespace {

template <class T>
std::size_t bytes(const std::vector<T>& list) {
    return list.size() * sizeof(T);
}

TEST(Memory, APointReadyForRegistrationTakesAtMost48Bytes) {
    const auto scan = labelled(std::make_shared<const Scan>(test::scanRoom().scan));
    RegistrationSettings settings;
    settings.reduce = 0.0;
    const PointCloud cloud = prepared(*scan, settings);
    for (const SearchMethod method : {SearchMethod::KdTree, SearchMethod::Forest}) {
        const std::size_t all = bytes(cloud.points) + bytes(cloud.normals) + bytes(cloud.labels) +
                                bytes(cloud.weights) + makeSearch(cloud, method)->memory();
        const double each = static_cast<double>(all) / static_cast<double>(cloud.size());
        std::printf("[          ] %.1f bytes a point\n", each);
        EXPECT_LE(each, 48.0);
    }
}

}  // namespace
}  // namespace leitstand
