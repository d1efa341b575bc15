#include "app/window/panes/map/storeys/storey_row.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/models/map/storey_text.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

constexpr int ButtonSize = 32;  ///< [px]

}  // namespace

StoreyRow::StoreyRow(QWidget* parent) : QFrame(parent), m_layout(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("storeys"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setAccessibleName(tr("Storeys of the map"));
    m_layout->setContentsMargins(3, 3, 3, 3);
    m_layout->setSpacing(3);
    hide();
}

void StoreyRow::add(std::optional<int> number, const QString& text, const QString& name) {
    auto* button = new QToolButton(this);
    button->setObjectName(number ? QStringLiteral("storey_%1").arg(*number) : QStringLiteral("storey_all"));
    button->setText(text);
    button->setAccessibleName(name);
    button->setToolTip(name);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::NoFocus);  // keys continue to drive
    button->setMinimumSize(ButtonSize, ButtonSize);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, this, [this, number] {
        setChosen(m_chosen, m_all);  // the click alone decides nothing
        emit wanted(number);
    });
    m_layout->addWidget(button);
    m_buttons.push_back({number, button});
}

void StoreyRow::setStoreys(const std::vector<Storey>& storeys) {
    for (const Button& one : m_buttons) delete one.button;
    m_buttons.clear();
    setVisible(storeys.size() > 1);
    if (storeys.size() < 2) return;
    for (auto storey = storeys.rbegin(); storey != storeys.rend(); ++storey)
        add(storey->number, storeyText(storey->number),
            tr("Storey %1, its floor at %2 m").arg(storeyText(storey->number), numberText(storey->floor, 1)));
    add(std::nullopt, tr("All", "storeys"), tr("All storeys"));
    setChosen(m_chosen, m_all);
    adjustSize();
}

void StoreyRow::setChosen(std::optional<int> number, bool all) {
    m_chosen = number;
    m_all = all;
    for (const Button& one : m_buttons) one.button->setChecked(one.number ? one.number == number : all);
}

}  // namespace leitstand
