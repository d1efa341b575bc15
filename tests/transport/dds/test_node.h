#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/support/dds/samples.h"
#include "tests/support/dds/test_domain.h"

namespace leitstand::test {

inline const std::string TestType = "std_msgs/msg/String";

[[nodiscard]] inline Qos reliable(int depth) {
    return {.depth = depth};
}
[[nodiscard]] inline Qos bestEffort(int depth = 5) {
    return {.reliability = Qos::Reliability::BestEffort, .depth = depth};
}
[[nodiscard]] inline Qos transientLocal(int depth) {
    return {.durability = Qos::Durability::TransientLocal, .depth = depth};
}

/// A node in @p domain; throws when there can be none.
[[nodiscard]] inline std::unique_ptr<Node> nodeIn(const TestDomain& domain, NodeSettings settings = {}) {
    settings.domain = domain.number();
    auto node = Node::create(settings);
    if (!node) throw std::runtime_error(node.error().text);
    return std::move(node).value();
}

/// The value of @p result; throws its error.
template <class T>
[[nodiscard]] T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().text);
    return std::move(result).value();
}

}  // namespace leitstand::test
