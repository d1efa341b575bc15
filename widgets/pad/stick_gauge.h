#pragma once

#include <QWidget>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Shows one stick of a gamepad as a bar: its position (tick), the dead zone (shade) and the resulting value
/// (fill).
class StickGauge final : public QWidget {
    Q_OBJECT
public:
    /// Shows the axis from the action @p plus at the left end to the opposite action at the right end.
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
