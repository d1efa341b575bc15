#pragma once

#include <QTimer>
#include <QWidget>

#include "widgets/models/live/robots/drive_state.h"

namespace leitstand {

/// Shows CO2 of the selected robot: value, trend arrow, its last two minutes and the alarm level.
class GasCell final : public QWidget {
    Q_OBJECT
public:
    explicit GasCell(QWidget* parent = nullptr);

    void show(const GasFigures& gas);
    using QWidget::show;
    [[nodiscard]] QSize sizeHint() const override { return {176, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {126, 150}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintTrend(QPainter& painter, const QRectF& area) const;

    GasFigures m_gas;
    QTimer m_trendDue;
};

}  // namespace leitstand
