#pragma once

#include <QAbstractButton>

namespace leitstand {

/// The stop of all robots: large, red in every theme and state, always of one size. Esc is the window's: it
/// is only written here.
class StopButton final : public QAbstractButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void stopRequested();  ///< of all robots, on press: not only when let go

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace leitstand
