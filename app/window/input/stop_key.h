#pragma once

#include <QObject>

namespace leitstand {

/// Emits pressed() at every Esc, whatever has the keyboard, even a dialog. Esc then has no other effect.
class StopKey final : public QObject {
    Q_OBJECT
public:
    explicit StopKey(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void pressed();
};

}  // namespace leitstand
