#pragma once

#include <QWidget>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// One stick of a gamepad as a bar: where the hand holds it (a tick), the dead zone (a shade) and what comes
/// of it (the fill).
class StickGauge final : public QWidget {
    Q_OBJECT
public:
    /// Between @p plus, drawn to the left, and its opposite.
    explicit StickGauge(PadAction plus, QWidget* parent = nullptr);

    void show(const PadBindings& bindings, const PadState& state);
    using QWidget::show;
    [[nodiscard]] QSize sizeHint() const override { return {180, 18}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, 18}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    PadAction m_plus;
    double m_raw = 0.0, m_shaped = 0.0, m_zone = 0.0;
};

}  // namespace leitstand
