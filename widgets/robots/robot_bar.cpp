#include "widgets/robots/robot_bar.h"

#include <algorithm>
#include <cstdlib>

#include <QButtonGroup>
#include <QEvent>
#include <QWheelEvent>

#include "widgets/models/live/robots/robot_row.h"
#include "widgets/robots/more_robots_button.h"
#include "widgets/robots/release_handle.h"
#include "widgets/robots/robot_bar_sizes.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand {
namespace {

constexpr int Space = 4;                      ///< between robots [px]
constexpr int Comfortable = 160, Most = 270;  ///< widths of a robot when there is room [px]
constexpr int Least = 3;                      ///< least number of visible robots

/// Returns the width of a row of @p count items, each @p each wide [px].
int rowWidth(int count, int each) {
    return std::max(0, count * (each + Space) - Space);
}

}  // namespace

RobotBar::RobotBar(QWidget* parent)
    : QWidget(parent),
      m_group(new QButtonGroup(this)),
      m_before(new MoreRobotsButton(MoreRobotsButton::End::Before, this)),
      m_after(new MoreRobotsButton(MoreRobotsButton::End::After, this)) {
    setAccessibleName(tr("Robots"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFixedHeight(robot_bar::Height);
    m_before->hide();
    m_after->hide();
    connect(m_before, &QAbstractButton::clicked, this, [this] { scroll(1 - capacity()); });
    connect(m_after, &QAbstractButton::clicked, this, [this] { scroll(capacity() - 1); });
}

void RobotBar::addButton() {
    const int place = static_cast<int>(m_buttons.size());
    const QString key = place < 9 ? QString::number(place + 1) : QString();
    auto* button = new RobotChipButton(key, this);
    if (!key.isEmpty()) button->setShortcut(QKeySequence(key));
    m_group->addButton(button);
    connect(button, &QAbstractButton::clicked, this,
            [this, button] { emit robotSelected(button->chip().face.name); });
    connect(button, &RobotChipButton::releaseRequested, this, &RobotBar::releaseRequested);
    button->installEventFilter(this);
    button->handle().installEventFilter(this);
    // Tab goes from each robot to its release handle, then to the next robot.
    setTabOrder(m_buttons.empty() ? static_cast<QWidget*>(m_before) : &m_buttons.back()->handle(), button);
    setTabOrder(button, &button->handle());
    setTabOrder(&button->handle(), m_after);
    m_buttons.push_back(button);
    button->show();
}

void RobotBar::show(const std::vector<RobotChip>& chips, const std::vector<StopLine>& stops,
                    const QString& selected) {
    const bool other = chips.size() != m_chips.size();
    while (m_buttons.size() < chips.size()) addButton();
    m_chips = chips;
    m_stops = stops;
    int chosen = -1;
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setVisible(i < chips.size());
        if (i >= chips.size()) continue;
        m_buttons[i]->show(chips[i], i < stops.size() ? stops[i] : StopLine{});
        if (chips[i].face.name == selected) chosen = static_cast<int>(i);
    }
    if (chosen >= 0) m_buttons[static_cast<std::size_t>(chosen)]->setChecked(true);
    if (other) {
        setMaximumWidth(std::max(1, rowWidth(static_cast<int>(chips.size()), Most)));
        updateGeometry();
    }
    if (chosen != m_selected) {
        m_selected = chosen;
        reveal(chosen);
    } else {
        place();
    }
}

int RobotBar::folded() const {
    return RobotChipButton::foldedWidth(font());
}

int RobotBar::capacity() const {
    const int count = static_cast<int>(m_chips.size());
    if (rowWidth(count, folded()) <= width()) return count;
    const int room = width() - 2 * (MoreRobotsButton::Width + Space);
    return std::clamp((room + Space) / (folded() + Space), 1, count);
}

QSize RobotBar::sizeHint() const {
    const int count = static_cast<int>(m_chips.size());
    return {rowWidth(count, std::max(Comfortable, folded())), robot_bar::Height};
}

QSize RobotBar::minimumSizeHint() const {
    const int count = static_cast<int>(m_chips.size());
    const int scrolled = rowWidth(Least, folded()) + 2 * (MoreRobotsButton::Width + Space);
    return {std::min(rowWidth(count, folded()), scrolled), robot_bar::Height};
}

void RobotBar::reveal(int place) {
    if (place >= 0) m_first = firstToReveal(place, capacity(), m_first);
    this->place();
}

void RobotBar::scroll(int robots) {
    m_first = std::clamp(m_first + robots, 0, std::max(0, static_cast<int>(m_chips.size()) - capacity()));
    place();
}

void RobotBar::place() {
    const int count = static_cast<int>(m_chips.size()), room = capacity();
    if (count == 0) return;
    m_first = std::clamp(m_first, 0, count - room);
    const RobotRow row = robotRowOf(count, room, m_first, m_selected);
    const bool scrolls = room < count;
    const int edge = scrolls ? MoreRobotsButton::Width + Space : 0;
    m_before->setVisible(scrolls);
    m_after->setVisible(scrolls);
    m_before->setGeometry(0, 0, MoreRobotsButton::Width, height());
    m_after->setGeometry(width() - MoreRobotsButton::Width, 0, MoreRobotsButton::Width, height());
    m_before->show(hiddenRobotsOf(row.before, m_chips, m_stops));
    m_after->show(hiddenRobotsOf(row.after, m_chips, m_stops));
    const int wide = std::min(Most, (width() - 2 * edge + Space) / room - Space);
    const auto put = [&](const std::vector<int>& places, int x) {
        for (const int place : places) {
            m_buttons[static_cast<std::size_t>(place)]->setGeometry(x, 0, wide, height());
            x += wide + Space;
        }
    };
    put(row.shown, edge);
    // Buttons out of sight stay visible to Qt, in their order: their shortcuts work, and Tab and arrows reach
    // them.
    put(row.before, -static_cast<int>(row.before.size()) * (wide + Space));
    put(row.after, width() + Space);
}

bool RobotBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        const auto found = std::find_if(m_buttons.begin(), m_buttons.end(), [&](RobotChipButton* button) {
            return watched == button || watched == &button->handle();
        });
        if (found != m_buttons.end()) reveal(static_cast<int>(found - m_buttons.begin()));
    }
    return QWidget::eventFilter(watched, event);
}

void RobotBar::resizeEvent(QResizeEvent* /*event*/) {
    reveal(m_selected);
}

void RobotBar::wheelEvent(QWheelEvent* event) {
    constexpr int Step = QWheelEvent::DefaultDeltasPerStep;
    m_turned += event->angleDelta().y() + event->angleDelta().x();
    if (std::abs(m_turned) >= Step) scroll(-m_turned / Step);
    m_turned %= Step;
    event->accept();
}

}  // namespace leitstand
