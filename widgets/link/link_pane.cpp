#include "widgets/link/link_pane.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/event/stream_role.h"
#include "widgets/link/stream_list.h"
#include "widgets/painting/number_box.h"
#include "widgets/tables/fields.h"

namespace leitstand {
namespace {

/// Adds @p field with its caption before it.
void addTo(QHBoxLayout& line, const QString& caption, QWidget& field, const QString& hint) {
    auto* label = new QLabel(caption, field.parentWidget());
    label->setBuddy(&field);
    field.setToolTip(hint);
    field.setAccessibleName(caption);
    line.addWidget(label);
    line.addWidget(&field);
}

}  // namespace

LinkPane::LinkPane(QAction& thin, QWidget* parent)
    : QWidget(parent), m_list(new StreamList(StreamTable::Of::Link, this)) {
    setObjectName(QStringLiteral("link"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_list, 1);
    layout->addWidget(editor());
    layout->addWidget(foot(thin));
    connect(m_list, &StreamList::chosenChanged, this, &LinkPane::showChosen);
    showChosen();
}

const StreamTable& LinkPane::table() const {
    return m_list->streams();
}

QWidget* LinkPane::editor() {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(10, 6, 10, 2);
    m_chosen = new QLabel(row);
    m_chosen->setMinimumWidth(90);
    m_chosen->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_enabled = new QCheckBox(tr("Sent"), row);
    m_enabled->setObjectName(QStringLiteral("enabled"));
    m_enabled->setToolTip(tr("Whether the robot sends this stream at all"));
    m_maps = new QCheckBox(tr("Makes the map"), row);
    m_maps->setObjectName(QStringLiteral("maps"));
    m_maps->setToolTip(
        tr("Whether the map is made from this cloud; the robot's others are shown, and used for "
           "obstacles"));
    m_rate = new NumberBox(0.0, 50.0, 1.0, 1, {}, row);
    m_rate->setObjectName(QStringLiteral("rate"));
    m_quality = new NumberBox(0.0, 100.0, 10.0, 0, {}, row);
    m_quality->setObjectName(QStringLiteral("quality"));
    m_width = new NumberBox(0.0, 1920.0, 160.0, 0, {}, row);
    m_width->setObjectName(QStringLiteral("width"));
    for (NumberBox* box : {m_rate, m_quality, m_width}) {
        box->setSpecialValueText(tr("free"));
        keepFromWheel(*box);
        connect(box, &QDoubleSpinBox::valueChanged, this, &LinkPane::takeOver);
    }
    line->addWidget(m_chosen, 1);
    line->addWidget(m_maps);
    line->addWidget(m_enabled);
    addTo(*line, tr("Hz"), *m_rate, tr("Samples a second, at most; 0: as the robot likes"));
    addTo(*line, tr("Quality"), *m_quality, tr("Of JPEG pictures, 1 to 100; 0: as the robot likes"));
    addTo(*line, tr("Width px"), *m_width, tr("Wider pictures are made smaller; 0: as the robot likes"));
    connect(m_enabled, &QCheckBox::toggled, this, &LinkPane::takeOver);
    connect(m_maps, &QCheckBox::toggled, this, [this](bool on) {
        const StreamRow* const chosen = m_list->chosen();
        if (!on || chosen == nullptr) return;
        emit mapChosen(chosen->face.name, QString::fromStdString(chosen->stream.topic));
    });
    return row;
}

QWidget* LinkPane::foot(QAction& thin) {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(10, 2, 10, 6);
    m_total = new QLabel(row);
    m_total->setObjectName(QStringLiteral("total"));
    m_total->setToolTip(tr("What all streams of all robots take of the link"));
    auto* button = new QToolButton(row);
    button->setObjectName(QStringLiteral("thin"));
    button->setDefaultAction(&thin);
    m_budget = new NumberBox(0.2, 100.0, 0.5, 1, {}, row);
    m_budget->setObjectName(QStringLiteral("budget"));
    keepFromWheel(*m_budget);
    connect(m_budget, &QDoubleSpinBox::valueChanged, this, &LinkPane::budgetChosen);
    line->addWidget(m_total, 1);
    line->addWidget(button);
    addTo(*line, tr("Mbit/s"), *m_budget, tr("What a thin link has room for, all robots together"));
    return row;
}

void LinkPane::show(std::vector<StreamRow> rows, double megabits, bool thin, double budget) {
    m_list->setRows(std::move(rows));
    showMaps();
    m_total->setText(tr("Link %1").arg(linkTotalText(megabits, thin, budget)));
    if (!m_budget->hasFocus()) {
        const QSignalBlocker quiet(m_budget);
        m_budget->setValue(budget);
    }
}

void LinkPane::showChosen() {
    const QScopedValueRollback showing(m_showing, true);
    const StreamRow* row = m_list->chosen();
    const bool settable = row != nullptr && row->settable;
    const bool picture = settable && row->stream.role == StreamRole::Picture;
    m_chosen->setText(row == nullptr ? tr("Choose a stream")
                      : !settable    ? tr("%1: not settable").arg(streamNameText(*row))
                                     : streamNameText(*row));
    m_chosen->setToolTip(m_chosen->text());
    m_enabled->setEnabled(settable);
    m_rate->setEnabled(settable);
    m_quality->setEnabled(picture);
    m_width->setEnabled(picture);
    showMaps();
    const StreamRequest request = row == nullptr ? StreamRequest{} : row->own;
    m_enabled->setChecked(request.enabled);
    m_rate->setValue(request.rate);
    m_quality->setValue(request.quality);
    m_width->setValue(request.maxWidth);
}

void LinkPane::showMaps() {
    const QSignalBlocker quiet(m_maps);
    const StreamRow* const row = m_list->chosen();
    m_maps->setVisible(row != nullptr && row->mayMap);
    m_maps->setChecked(row != nullptr && row->maps);
    // One cloud makes the map: another is chosen, none is taken away.
    m_maps->setEnabled(row != nullptr && row->mayMap && !row->maps);
}

void LinkPane::takeOver() {
    const StreamRow* row = m_list->chosen();
    if (m_showing || row == nullptr || !row->settable) return;
    emit requested(row->face.name, QString::fromStdString(row->stream.topic),
                   StreamRequest{.enabled = m_enabled->isChecked(),
                                 .rate = m_rate->value(),
                                 .quality = static_cast<int>(m_quality->value()),
                                 .maxWidth = static_cast<int>(m_width->value())});
}

}  // namespace leitstand
