#include "tests/app/reach.h"

#include <algorithm>
#include <set>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "widgets/robots/release_handle.h"

namespace leitstand::test {
namespace {

/// A part of another one, or of Qt's own: its whole is looked at.
bool isPart(const QWidget& one) {
    const QWidget* const parent = one.parentWidget();
    return one.objectName().startsWith(QStringLiteral("qt_")) || qobject_cast<const QHeaderView*>(&one) ||
           one.inherits("QTableCornerButton") || qobject_cast<const QTabBar*>(parent) ||
           qobject_cast<const QComboBox*>(parent) || qobject_cast<const QAbstractSpinBox*>(parent);
}

bool isUsed(const QWidget& one) {
    return qobject_cast<const QAbstractButton*>(&one) || qobject_cast<const QAbstractItemView*>(&one) ||
           qobject_cast<const QAbstractSpinBox*>(&one) || qobject_cast<const QComboBox*>(&one) ||
           qobject_cast<const QLineEdit*>(&one) || qobject_cast<const QSlider*>(&one) ||
           (qobject_cast<const ReleaseHandle*>(&one) && one.focusPolicy() != Qt::NoFocus);
}

std::vector<QWidget*> used(const QWidget& window) {
    std::vector<QWidget*> all;
    for (QWidget* one : window.findChildren<QWidget*>()) {
        const bool here = one->window() == &window && one->isVisible() && one->isEnabled();
        if (here && isUsed(*one) && !isPart(*one)) all.push_back(one);
    }
    return all;
}

bool hasName(const QWidget& one) {
    if (!one.accessibleName().isEmpty()) return true;
    if (const auto* button = qobject_cast<const QAbstractButton*>(&one)) return !button->text().isEmpty();
    const auto labels = one.window()->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&one](const QLabel* label) { return label->buddy() == &one; });
}

bool hasKey(const QAbstractButton& button) {
    if (!button.shortcut().isEmpty()) return true;
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    return tool != nullptr && tool->defaultAction() != nullptr &&
           !tool->defaultAction()->shortcut().isEmpty();
}

std::string nameOf(const QWidget& one) {
    std::string name = one.metaObject()->className();
    for (const QWidget* part = &one; part != nullptr; part = part->parentWidget()) {
        if (part->objectName().isEmpty()) continue;
        return name + " in " + part->objectName().toStdString();
    }
    return name;
}

/// What Tab comes to, one after the other, until it is where it began.
std::set<const QWidget*> reachedByTab(QWidget& window) {
    constexpr int Most = 400;
    std::set<const QWidget*> reached;
    window.activateWindow();
    // A dialog counts as active where its parent is: qWaitForWindowActive() would not wait.
    if (!QTest::qWaitFor([&window] { return QApplication::activeWindow() == &window; })) return reached;
    for (int i = 0; i < Most; ++i) {
        QWidget* const now = QApplication::focusWidget();
        if (now != nullptr && now->window() == &window && !reached.insert(now).second && i > 1) break;
        QTest::keyClick(now == nullptr || now->window() != &window ? &window : now, Qt::Key_Tab);
    }
    return reached;
}

bool isReached(const QWidget& one, const std::set<const QWidget*>& reached) {
    if (reached.contains(&one)) return true;
    const auto* button = qobject_cast<const QAbstractButton*>(&one);
    if (button == nullptr) return false;
    if (hasKey(*button)) return true;
    // Of buttons of which one is down, arrows choose.
    const QButtonGroup* const group = button->group();
    if (group == nullptr || !group->exclusive()) return false;
    const auto all = group->buttons();
    return std::any_of(all.begin(), all.end(),
                       [&reached](const QAbstractButton* other) { return reached.contains(other); });
}

/// What a screen reader says of a row.
QString spoken(const QAbstractItemView& view, int row) {
    QStringList reported;
    const QAbstractItemModel& model = *view.model();
    for (int column = 0; column < model.columnCount(view.rootIndex()); ++column) {
        const QModelIndex cell = model.index(row, column, view.rootIndex());
        const QString own = cell.data(Qt::AccessibleTextRole).toString();
        reported += own.isEmpty() ? cell.data().toString() : own;
    }
    return reported.join(QLatin1Char(' ')).trimmed();
}

/// What is wrong with the rows of @p view: they are walked by arrows, and each says something.
std::vector<std::string> rowsOutOfReach(QAbstractItemView& view) {
    constexpr int Most = 40;
    std::vector<std::string> wrong;
    if (view.model() == nullptr || view.selectionMode() == QAbstractItemView::NoSelection) return wrong;
    const int rows = std::min(Most, view.model()->rowCount(view.rootIndex()));
    if (rows == 0) return wrong;
    view.setFocus(Qt::TabFocusReason);
    std::set<int> walked;
    for (int i = 0; i < 2 * rows; ++i) {
        if (view.currentIndex().isValid()) walked.insert(view.currentIndex().row());
        QTest::keyClick(&view, i < rows ? Qt::Key_Up : Qt::Key_Down);
    }
    if (view.currentIndex().isValid()) walked.insert(view.currentIndex().row());
    for (int row = 0; row < rows; ++row) {
        const std::string name = nameOf(view) + ", row " + std::to_string(row);
        if (!walked.contains(row)) wrong.push_back(name + " is not reached by arrows");
        if (spoken(view, row).isEmpty()) wrong.push_back(name + " says nothing");
    }
    return wrong;
}

}  // namespace

int thingsToUse(const QWidget& window) {
    return static_cast<int>(used(window).size());
}

std::vector<std::string> outOfReach(QWidget& window) {
    std::vector<std::string> wrong;
    const auto reached = reachedByTab(window);
    for (const QWidget* one : used(window)) {
        if (!hasName(*one)) wrong.push_back(nameOf(*one) + " has no name");
        if (!isReached(*one, reached)) wrong.push_back(nameOf(*one) + " is not reached by keys");
        // Their label says all that there is to say.
        const bool asked = qobject_cast<const QInputDialog*>(one->parentWidget()) != nullptr;
        const bool ofBox = qobject_cast<const QDialogButtonBox*>(one->parentWidget()) != nullptr;
        const bool list = qobject_cast<const QAbstractItemView*>(one) != nullptr;  // rows have their own
        if (!list && !asked && !ofBox && one->toolTip().isEmpty())
            wrong.push_back(nameOf(*one) + " has no tool tip");
    }
    for (QWidget* one : used(window)) {
        auto* const view = qobject_cast<QAbstractItemView*>(one);
        if (view == nullptr) continue;
        for (const std::string& row : rowsOutOfReach(*view)) wrong.push_back(row);
    }
    return wrong;
}

}  // namespace leitstand::test
