#pragma once

#include <functional>

#include <QString>

#include "core/base/progress.h"

namespace leitstand {

/// What a window tells of work that it waits for.
struct WorkInFront {
    QString name;             ///< objectName() of the window
    QString label;            ///< what is being done
    bool cancellable = true;  ///< whether it can be stopped half-way
};

/// Does @p work on a thread of its own, in front of a window that tells how far it is and cancels it. Returns
/// once it has ended, cancelled or not.
void workInFront(const WorkInFront& look, const std::function<void(const Progress&)>& work);

}  // namespace leitstand
