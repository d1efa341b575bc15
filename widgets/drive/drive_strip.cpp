#include "widgets/drive/drive_strip.h"

#include <QFrame>
#include <QHBoxLayout>

#include "widgets/drive/attitude_gauge.h"
#include "widgets/drive/energy_cell.h"
#include "widgets/drive/gas_cell.h"
#include "widgets/drive/mode_cell.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

/// A thin line between cells.
class Separator final : public QWidget {
public:
    explicit Separator(QWidget* parent) : QWidget(parent) { setFixedWidth(1); }

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter(this).fillRect(rect(), coloursOf(presentTheme()).line);
    }
};

}  // namespace

DriveStrip::DriveStrip(QWidget* parent)
    : QWidget(parent),
      m_mode(new ModeCell(this)),
      m_attitude(new AttitudeGauge(this)),
      m_energy(new EnergyCell(this)),
      m_gas(new GasCell(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_mode, 5);
    for (QWidget* cell :
         {static_cast<QWidget*>(m_attitude), static_cast<QWidget*>(m_energy), static_cast<QWidget*>(m_gas)}) {
        layout->addWidget(new Separator(this));
        layout->addWidget(cell, 3);
    }
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    connect(m_mode, &ModeCell::grantAsked, this, &DriveStrip::grantAsked);
    connect(m_mode, &ModeCell::grantGivenUp, this, &DriveStrip::grantGivenUp);
    connect(m_mode, &ModeCell::grantAnswered, this, &DriveStrip::grantAnswered);
}

void DriveStrip::show(const DriveState& state) {
    m_mode->show(state);
    m_attitude->show(state.attitude);
    m_energy->show(state);
    m_gas->show(state.gas);
}

}  // namespace leitstand
