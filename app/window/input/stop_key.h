#pragma once

#include <QObject>

namespace leitstand {

/// Esc stops always, whatever has the keyboard, even a dialog.
class StopKey final : public QObject {
    Q_OBJECT
public:
    explicit StopKey(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void pressed();
};

}  // namespace leitstand
