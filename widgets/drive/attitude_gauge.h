#pragma once

#include <QWidget>

#include "widgets/models/live/robots/drive_state.h"

namespace leitstand {

/// Shows roll and pitch of a robot as the horizon seen from inside it. The dial is dotted beyond the angles
/// at which the robot tips over.
class AttitudeGauge final : public QWidget {
    Q_OBJECT
public:
    explicit AttitudeGauge(QWidget* parent = nullptr);

    void show(const AttitudeFigures& attitude);
    using QWidget::show;
    [[nodiscard]] QSize sizeHint() const override { return {152, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {134, 150}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintDial(QPainter& painter, const QPointF& centre, double radius) const;

    AttitudeFigures m_attitude;
};

}  // namespace leitstand
