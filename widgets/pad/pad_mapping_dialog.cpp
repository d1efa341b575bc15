#include "widgets/pad/pad_mapping_dialog.h"

#include <cmath>

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTableView>

#include "widgets/pad/pad_bar_delegate.h"
#include "widgets/pad/stick_gauge.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {
namespace {

constexpr int RowHeight = 26;  ///< [px]

int percent(double share) {
    return static_cast<int>(std::lround(100.0 * share));
}

}  // namespace

PadMappingDialog::PadMappingDialog(QWidget* parent)
    : QWidget(parent, Qt::Tool),
      m_pads(new QComboBox(this)),
      m_view(new QTableView(this)),
      m_word(new QLabel(this)) {
    setWindowTitle(tr("Gamepad"));
    setAttribute(Qt::WA_StyledBackground);
    m_pads->setToolTip(tr("The gamepad that drives; STOP works on all"));
    m_pads->setAccessibleName(tr("Gamepad that drives"));
    m_word->setWordWrap(true);
    m_word->setMinimumHeight(34);
    buildTable();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 12);
    column->addWidget(m_pads);
    column->addWidget(m_view, 1);
    column->addWidget(m_word);
    column->addWidget(buildShape());
    column->addWidget(buildButtons());
    connect(m_pads, &QComboBox::activated, this,
            [this](int) { emit padChosen(m_pads->currentData().toInt()); });
    connect(&m_table, &PadTable::changed, this, &PadMappingDialog::showBindings);
    connect(&m_table, &PadTable::refused, m_word, &QLabel::setText);
    resize(440, 720);
    setPads({}, -1);
    showBindings();
}

void PadMappingDialog::buildTable() {
    m_view->setModel(&m_table);
    dressTable(*m_view, RowHeight);
    m_view->setItemDelegateForColumn(PadTable::Control, new PadBarDelegate(m_view));
    m_view->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_view->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_view->setAccessibleName(tr("What the gamepad does, and by which control"));
    connect(m_view, &QTableView::activated, this,
            [this](const QModelIndex& at) { m_table.capture(at.row()); });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        m_table.capture(-1);
        showBindings();
    });
}

QSlider* PadMappingDialog::addSlider(QGridLayout& grid, int row, const QString& name, const QString& hint,
                                     int least, int most) {
    auto* label = new QLabel(name, this);
    auto* slider = new QSlider(Qt::Horizontal, this);
    auto* number = new QLabel(this);
    number->setMinimumWidth(44);
    number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    slider->setRange(least, most);
    slider->setToolTip(hint);
    slider->setAccessibleName(QString(name).remove(QLatin1Char('&')));
    slider->setAccessibleDescription(hint);
    label->setBuddy(slider);
    grid.addWidget(label, row, 0);
    grid.addWidget(slider, row, 1);
    grid.addWidget(number, row, 2);
    connect(slider, &QSlider::valueChanged, number,
            [number](int value) { number->setText(tr("%1 %").arg(value)); });
    connect(slider, &QSlider::valueChanged, this, &PadMappingDialog::readShape);
    number->setText(tr("%1 %").arg(slider->value()));
    return slider;
}

QWidget* PadMappingDialog::buildShape() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    m_zone = addSlider(*grid, 0, tr("&Dead zone"), tr("Around the middle of a stick nothing moves"), 0,
                       percent(PadBindings::MostDeadZone));
    m_expo = addSlider(*grid, 1, tr("&Fine middle"), tr("Sticks are finer around their middle"), 0, 100);
    m_press = addSlider(*grid, 2, tr("&Trigger at"), tr("How far a trigger is pulled until it counts"),
                        percent(PadBindings::LeastPress), percent(PadBindings::MostPress));
    const std::pair<PadAction, QString> sticks[] = {{PadAction::Forward, tr("Forward ← → back")},
                                                    {PadAction::TurnLeft, tr("Turn left ← → right")},
                                                    {PadAction::PanLeft, tr("Camera left ← → right")},
                                                    {PadAction::TiltUp, tr("Camera up ← → down")}};
    int row = 3;
    for (const auto& [action, name] : sticks) {
        auto* label = new QLabel(name, box);
        label->setProperty("muted", true);
        m_gauges.push_back(new StickGauge(action, box));
        grid->addWidget(label, row, 0);
        grid->addWidget(m_gauges.back(), row++, 1, 1, 2);
    }
    return box;
}

QWidget* PadMappingDialog::buildButtons() {
    auto* box = new QWidget(this);
    auto* line = new QHBoxLayout(box);
    line->setContentsMargins(0, 4, 0, 0);
    const auto button = [&](const QString& text, const QString& hint, auto act) {
        auto* made = new QPushButton(text, box);
        made->setToolTip(hint);
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, act);
        line->addWidget(made);
        return made;
    };
    m_set = button(tr("Se&t …"), tr("The next control that you push does what is selected"),
                   [this] { m_table.capture(m_table.captured() < 0 ? row() : -1); });
    m_clear = button(tr("&Clear"), tr("No control does what is selected"), [this] { m_table.clear(row()); });
    line->addStretch(1);
    m_reset =
        button(tr("&Usual"), tr("What gamepads usually do here; not saved yet"), [this] { m_table.reset(); });
    m_save = button(tr("&Save"), tr("Use this now, and whenever such a gamepad is plugged in"), [this] {
        emit saved(m_table.bindings());
        m_table.setBindings(PadBindings(m_table.bindings()));
    });
    return box;
}

int PadMappingDialog::row() const {
    return m_view->currentIndex().isValid() ? m_view->currentIndex().row() : -1;
}

void PadMappingDialog::setPads(const std::vector<PadChoice>& pads, int chosen) {
    m_pads->clear();
    for (const PadChoice& pad : pads) m_pads->addItem(pad.name, pad.id);
    if (pads.empty()) m_pads->addItem(tr("No gamepad is plugged in"), -1);
    m_pads->setCurrentIndex(std::max(0, m_pads->findData(chosen)));
    m_pads->setEnabled(!pads.empty());
    setBindings(m_table.bindings());
}

void PadMappingDialog::setBindings(const PadBindings& bindings) {
    if (m_table.isChanged() && bindings.layout == m_table.bindings().layout) return;
    m_table.setBindings(bindings);
}

void PadMappingDialog::setState(const PadState& state) {
    const bool came = state.connected != m_table.state().connected;
    m_table.setState(state);
    if (came) {
        showBindings();
    } else {
        showState();
    }
}

void PadMappingDialog::showState() {
    for (StickGauge* gauge : m_gauges) gauge->show(m_table.bindings(), m_table.state());
}

void PadMappingDialog::showBindings() {
    const PadBindings& bindings = m_table.bindings();
    m_showing = true;
    m_zone->setValue(percent(bindings.deadZone));
    m_expo->setValue(percent(bindings.expo));
    m_press->setValue(percent(bindings.press));
    m_showing = false;
    const bool any = m_table.state().connected, waits = m_table.captured() >= 0;
    const QString fault = m_table.fault();
    m_set->setText(waits ? tr("Canc&el") : tr("Se&t …"));
    m_set->setEnabled(waits || (any && row() >= 0));
    m_clear->setEnabled(!waits && m_table.canClear(row()));
    m_save->setEnabled(any && m_table.isChanged() && fault.isEmpty());
    m_reset->setEnabled(any);
    QString word = padDriveHint(bindings);
    if (m_table.isChanged()) word = tr("Not saved yet.") + QLatin1Char(' ') + word;
    if (any && !fault.isEmpty()) word = fault;
    if (waits) {
        const QString does = m_table.index(m_table.captured(), PadTable::Action).data().toString();
        word = tr("Push the control for “%1” now.").arg(does);
    }
    m_word->setText(word);
    showState();
}

void PadMappingDialog::readShape() {
    if (m_showing || m_press == nullptr) return;
    m_table.setShape(m_zone->value() / 100.0, m_expo->value() / 100.0, m_press->value() / 100.0);
}

bool PadMappingDialog::event(QEvent* event) {
    // Input for another window must not bind anything.
    if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::Hide) m_table.capture(-1);
    return QWidget::event(event);
}

}  // namespace leitstand
