#pragma once

#include <QAbstractButton>

namespace leitstand {

/// The button that stops all robots: large, of fixed size, red in every theme and state. It shows the key
/// Esc, which the window handles.
class StopButton final : public QAbstractButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void stopRequested();  ///< requests a stop of all robots; emitted on press, not on release

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace leitstand
