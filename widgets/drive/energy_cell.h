#pragma once

#include <QWidget>

#include "widgets/models/live/robots/drive_state.h"

namespace leitstand {

/// Shows battery and link of the selected robot.
class EnergyCell final : public QWidget {
    Q_OBJECT
public:
    explicit EnergyCell(QWidget* parent = nullptr);

    void show(const DriveState& state);
    using QWidget::show;
    [[nodiscard]] QSize sizeHint() const override { return {156, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {136, 150}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    BatteryFigures m_battery;
    QStringList m_link;  ///< DriveState::link
    QString m_reason;
    Tone m_linkTone = Tone::Normal;
};

}  // namespace leitstand
