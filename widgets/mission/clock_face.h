#pragma once

#include <QAbstractButton>

#include "widgets/models/live/texts/clock_text.h"

namespace leitstand {

/// The mission clock in the top bar: a small caption and the time in large digits. A click opens its menu.
/// Its size does not depend on its text.
class ClockFace final : public QAbstractButton {
    Q_OBJECT
public:
    explicit ClockFace(QWidget* parent = nullptr);

    void show(const ClockText& text);
    using QWidget::show;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ClockText m_text;
};

}  // namespace leitstand
