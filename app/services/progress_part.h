#pragma once

#include "core/base/progress.h"

namespace leitstand {

/// Returns the progress of one part of the work of @p whole, from its share @p begin to its share @p end (0
/// to 1). @p whole must outlive the result.
[[nodiscard]] inline Progress part(const Progress& whole, double begin, double end) {
    return {[&whole, begin, end](double fraction) { whole.done(begin + (end - begin) * fraction); },
            whole.stop};
}

}  // namespace leitstand
