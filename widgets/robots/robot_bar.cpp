#include "widgets/robots/robot_bar.h"

#include <QButtonGroup>
#include <QHBoxLayout>

#include "widgets/robots/robot_chip_button.h"

namespace leitstand {

RobotBar::RobotBar(QWidget* parent)
    : QWidget(parent), m_layout(new QHBoxLayout(this)), m_group(new QButtonGroup(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(10);
    setAccessibleName(tr("Robots"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void RobotBar::show(const std::vector<RobotChip>& chips, const QString& selected) {
    while (m_chips.size() < chips.size()) {
        const auto place = static_cast<int>(m_chips.size());
        const QString key = place < 9 ? QString::number(place + 1) : QString();
        auto* button = new RobotChipButton(key, this);
        if (!key.isEmpty()) button->setShortcut(QKeySequence(key));
        m_group->addButton(button);
        m_layout->addWidget(button);
        connect(button, &QAbstractButton::clicked, this,
                [this, button] { emit robotSelected(button->chip().face.name); });
        m_chips.push_back(button);
    }
    for (std::size_t i = 0; i < m_chips.size(); ++i) {
        m_chips[i]->setVisible(i < chips.size());
        if (i >= chips.size()) continue;
        m_chips[i]->show(chips[i]);
        if (chips[i].face.name == selected) m_chips[i]->setChecked(true);
    }
}

}  // namespace leitstand
