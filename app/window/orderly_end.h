#pragma once

#include <QObject>

namespace leitstand {

/// While it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP ends the program as closing its windows does:
/// what is recorded is closed, what is remembered is written. A second one ends it at once. GUI thread, at
/// most one at a time.
class OrderlyEnd final : public QObject {
    Q_OBJECT
public:
    explicit OrderlyEnd(QObject* parent = nullptr);
    ~OrderlyEnd() override;
};

}  // namespace leitstand
