#pragma once

#include <functional>
#include <stop_token>

#include <QObject>

#include "app/services/interrupt.h"

namespace leitstand {

/// While this object exists, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP closes all windows without
/// questions and ends the program. Recordings are completed, and settings are stored. After 5 s the program
/// ends in any case, even if a library hangs. A second signal ends it at once (InterruptGuard). GUI thread;
/// at most one at a time.
class OrderlyEnd final : public QObject {
    Q_OBJECT
public:
    explicit OrderlyEnd(QObject* parent = nullptr);

    /// Returns whether a signal asked the program to end, so that no window may open any more.
    [[nodiscard]] static bool asked();

private:
    const InterruptGuard m_interrupt;
    const std::stop_callback<std::function<void()>> m_came;
};

}  // namespace leitstand
