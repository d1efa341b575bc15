#pragma once

#include <memory>

#include "core/mission/state/robot_state.h"

namespace leitstand::test {

/// Puts a copy in the place of @p latest, which nobody else holds, and returns it to change.
template <class T>
[[nodiscard]] Latest<T>& editable(LatestPtr<T>& latest) {
    const auto copy = std::make_shared<Latest<T>>(*latest);
    latest = copy;
    return *copy;
}

}  // namespace leitstand::test
