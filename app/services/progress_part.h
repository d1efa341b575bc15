#pragma once

#include "core/base/progress.h"

namespace leitstand {

/// Returns the progress of a part of some work, from share @p begin to share @p end of it. @p whole outlives
/// it.
[[nodiscard]] inline Progress part(const Progress& whole, double begin, double end) {
    return {[&whole, begin, end](double fraction) { whole.done(begin + (end - begin) * fraction); },
            whole.stop};
}

}  // namespace leitstand
