#pragma once

#include <QAbstractButton>

#include "widgets/models/live/texts/clock_text.h"

namespace leitstand {

/// The mission's clock in the top bar: what it counts, small, and the time, large. A click is for its menu.
/// Its size never depends on what it shows.
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
