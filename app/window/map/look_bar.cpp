#include "app/window/map/look_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "app/window/map/view_state.h"
#include "widgets/painting/number_box.h"

namespace leitstand {
namespace {

constexpr double LowestHeight = -100.0, HighestHeight = 100.0;  ///< [m]
constexpr double CentimetresInMetre = 100.0;

QLabel* caption(const QString& text, QWidget* field, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("muted", true);
    label->setBuddy(field);
    return label;
}

QHBoxLayout* lineOf(QWidget* group) {
    auto* line = new QHBoxLayout(group);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
    return line;
}

void fill(NumberBox& box, double value) {
    const QSignalBlocker quiet(&box);
    box.setValue(value);
}

}  // namespace

LookBar::LookBar(ViewState& state, QWidget* parent)
    : QWidget(parent),
      m_state(state),
      m_edge(new NumberBox(5, 50, 5, 0, tr("cm"), this)),
      m_low(new NumberBox(LowestHeight, HighestHeight, 0.1, 1, tr("m"), this)),
      m_high(new NumberBox(LowestHeight, HighestHeight, 0.1, 1, tr("m"), this)) {
    m_edge->setObjectName(QStringLiteral("voxelEdge"));
    m_low->setObjectName(QStringLiteral("clipLow"));
    m_high->setObjectName(QStringLiteral("clipHigh"));
    m_voxels = voxelGroup();
    m_clip = clipGroup();
    auto* line = lineOf(this);
    line->setContentsMargins(10, 0, 10, 4);
    line->setSpacing(20);
    line->addWidget(m_voxels);
    line->addWidget(m_clip);
    line->addStretch(1);
    connect(m_edge, &QDoubleSpinBox::valueChanged, this, [this](double edge) {
        m_state.alter([edge](MapViewSettings& view) { view.voxelSize = edge / CentimetresInMetre; });
    });
    connect(m_low, &QDoubleSpinBox::valueChanged, this, [this](double height) {
        m_state.alter([height](MapViewSettings& view) { view.minHeight = height; });
    });
    connect(m_high, &QDoubleSpinBox::valueChanged, this, [this](double height) {
        m_state.alter([height](MapViewSettings& view) { view.maxHeight = height; });
    });
    connect(&state, &ViewState::changed, this, &LookBar::showState);
    showState();
}

QWidget* LookBar::voxelGroup() {
    auto* group = new QWidget(this);
    auto* line = lineOf(group);
    line->addWidget(caption(tr("Edge of the voxels"), m_edge, group));
    line->addWidget(m_edge);
    return group;
}

QWidget* LookBar::clipGroup() {
    auto* group = new QWidget(this);
    group->setToolTip(tr("Heights above the first scan's scanner, in its frame"));
    auto* line = lineOf(group);
    line->addWidget(caption(tr("Heights from"), m_low, group));
    line->addWidget(m_low);
    line->addWidget(caption(tr("to"), m_high, group));
    line->addWidget(m_high);
    return group;
}

void LookBar::showState() {
    const MapViewSettings& view = m_state.settings();
    const bool voxels = view.look == MapLook::Voxels;
    const bool clip = view.minHeight.has_value() || view.maxHeight.has_value();
    fill(*m_edge, CentimetresInMetre * view.voxelSize);
    if (clip) {
        const QSignalBlocker quietLow(m_low), quietHigh(m_high);
        // Earlier bounds would clamp the new values.
        for (NumberBox* one : {m_low, m_high}) one->setRange(LowestHeight, HighestHeight);
        m_low->setValue(view.minHeight.value_or(LowestHeight));
        m_high->setValue(view.maxHeight.value_or(HighestHeight));
        m_low->setMaximum(m_high->value());
        m_high->setMinimum(m_low->value());
    }
    m_voxels->setVisible(voxels);
    m_clip->setVisible(clip);
    setVisible(voxels || clip);
}

}  // namespace leitstand
