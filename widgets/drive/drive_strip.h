#pragma once

#include <QWidget>

#include "widgets/models/live/robots/drive_state.h"

namespace leitstand {

class AttitudeGauge;
class EnergyCell;
class GasCell;
class ModeCell;

/// The strip below the panes: mode, hold, motion, attitude, battery, link and CO2 of the selected robot.
class DriveStrip final : public QWidget {
    Q_OBJECT
public:
    explicit DriveStrip(QWidget* parent = nullptr);

    /// Shows @p state, the result of driveStateOf() for the selected robot.
    void show(const DriveState& state);
    using QWidget::show;

signals:
    void grantAsked();                 ///< the operator requests the grant to drive
    void grantGivenUp();               ///< the operator gives up the grant, or withdraws the request
    void grantAnswered(bool consent);  ///< the operator answers the station that requests the grant

private:
    ModeCell* m_mode;
    AttitudeGauge* m_attitude;
    EnergyCell* m_energy;
    GasCell* m_gas;
};

}  // namespace leitstand
