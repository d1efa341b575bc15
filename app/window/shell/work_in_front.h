#pragma once

#include <functional>

#include <QString>

#include "core/base/progress.h"

namespace leitstand {

/// How a window shows work that the program waits for.
struct WorkInFront {
    QString name;             ///< objectName() of the window
    QString label;            ///< what is being done
    bool cancellable = true;  ///< whether it can be stopped half-way
};

/// Does @p work on a thread of its own. A window shows its progress and can cancel it. Returns once the work
/// has ended, cancelled or not.
void workInFront(const WorkInFront& look, const std::function<void(const Progress&)>& work);

}  // namespace leitstand
