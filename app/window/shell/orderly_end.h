#pragma once

#include <functional>
#include <stop_token>

#include <QObject>

#include "app/services/interrupt.h"

namespace leitstand {

/// While it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP ends the program as closing its windows does:
/// recordings are closed, and what is remembered is written. That takes at most 5 s, whatever libraries do. A
/// second signal ends it at once. GUI thread, at most one at a time.
class OrderlyEnd final : public QObject {
    Q_OBJECT
public:
    explicit OrderlyEnd(QObject* parent = nullptr);

    /// Returns whether the program was asked to end: no window opens any more.
    [[nodiscard]] static bool asked();

private:
    const InterruptGuard m_interrupt;
    const std::stop_callback<std::function<void()>> m_came;
};

}  // namespace leitstand
