#include "app/window/layouts/layout_switch.h"

#include <algorithm>

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

namespace leitstand {
namespace {

constexpr int Around = 34;    ///< width of a button with a menu, without its text [px]
constexpr int Longest = 120;  ///< longer names, given by people, end in dots [px]
constexpr int Height = 28;    ///< [px]

}  // namespace

LayoutSwitch::LayoutSwitch(QWidget* parent)
    : QWidget(parent),
      m_row(new QWidget(this)),
      m_line(new QHBoxLayout(m_row)),
      m_button(new QToolButton(this)),
      m_menu(new QMenu(m_button)) {
    setAccessibleName(tr("Layout"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_row->setObjectName(QStringLiteral("layoutBar"));
    m_row->setAttribute(Qt::WA_StyledBackground);
    m_line->setContentsMargins(0, 0, 1, 0);  // the bar ends the last segment
    m_line->setSpacing(0);
    m_button->setObjectName(QStringLiteral("layoutMenu"));
    m_button->setProperty("folded", true);
    m_button->setMenu(m_menu);
    m_button->setPopupMode(QToolButton::InstantPopup);
    m_button->setFocusPolicy(Qt::TabFocus);  // a click does not take the keys from driving
    m_button->hide();
}

void LayoutSwitch::clear() {
    for (QAction* choice : m_choices) choice->disconnect(this);
    m_choices.clear();
    m_menu->clear();
    qDeleteAll(m_row->findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly));
    updateGeometry();
}

void LayoutSwitch::add(QAction& choice, const QString& name) {
    m_choices.push_back(&choice);
    m_menu->addAction(&choice);
    connect(&choice, &QAction::changed, this, &LayoutSwitch::showChecked);
    auto* button = new QToolButton(m_row);
    button->setDefaultAction(&choice);
    button->setObjectName(name);
    button->setProperty("segment", true);
    button->setFocusPolicy(Qt::TabFocus);
    m_line->addWidget(button);
    showChecked();
    updateGeometry();
}

void LayoutSwitch::showChecked() {
    const auto checked = std::find_if(m_choices.begin(), m_choices.end(),
                                      [](const QAction* choice) { return choice->isChecked(); });
    if (checked == m_choices.end()) return;
    const QString title = (*checked)->iconText();
    m_button->setText(m_button->fontMetrics().elidedText(title, Qt::ElideRight, Longest));
    m_button->setAccessibleName(tr("Layout %1").arg(title));
    m_button->setToolTip(tr("Layout %1; a click shows the others").arg(title));
}

int LayoutSwitch::foldedWidth(const QAction& choice) const {
    return Around + std::min(Longest, m_button->fontMetrics().horizontalAdvance(choice.iconText()));
}

bool LayoutSwitch::isFolded() const {
    return width() < sizeHint().width();
}

QSize LayoutSwitch::sizeHint() const {
    return {m_line->sizeHint().width(), Height};
}

QSize LayoutSwitch::minimumSizeHint() const {
    int widest = 0;
    for (const QAction* choice : m_choices) widest = std::max(widest, foldedWidth(*choice));
    return {std::min(widest, sizeHint().width()), Height};
}

void LayoutSwitch::fold() {
    const bool folded = isFolded();
    m_row->setVisible(!folded);
    m_button->setVisible(folded);
    m_row->setGeometry(rect());
    m_button->setGeometry(rect());
}

void LayoutSwitch::resizeEvent(QResizeEvent* /*event*/) {
    fold();
}

}  // namespace leitstand
