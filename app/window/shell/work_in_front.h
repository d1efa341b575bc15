#pragma once

#include <functional>

#include <QString>

#include "core/base/progress.h"

namespace leitstand {

/// How a window shows work for which the program waits.
struct WorkInFront {
    QString name;             ///< objectName() of the window
    QString label;            ///< text that says what is being done
    bool cancellable = true;  ///< whether it can be cancelled
};

/// Does @p work on a separate thread. A window shows its progress and can cancel it. Returns when the work
/// has ended, whether cancelled or not.
void workInFront(const WorkInFront& look, const std::function<void(const Progress&)>& work);

}  // namespace leitstand
