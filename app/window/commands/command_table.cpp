#include "app/window/commands/command_table.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "widgets/icons.h"

namespace leitstand {

CommandTable::CommandTable(QMainWindow& window) : QObject(&window), m_window(window) {
    const std::pair<CommandMenu, QString> menus[] = {
        {CommandMenu::Mission, tr("&Mission")}, {CommandMenu::Robot, tr("&Robot")},
        {CommandMenu::Cameras, tr("&Cameras")}, {CommandMenu::Map, tr("M&ap")},
        {CommandMenu::View, tr("&View")},       {CommandMenu::Help, tr("&Help")}};
    for (const auto& [id, title] : menus) {
        QMenu* menu = window.menuBar()->addMenu(title);
        menu->setToolTipsVisible(true);
        m_menus[id] = menu;
    }
}

QAction& CommandTable::add(const Command& command) {
    const QString& id = command.id;
    Q_ASSERT(!m_entries.contains(id));
    auto* action = new QAction(command.text, this);
    action->setObjectName(id);
    action->setCheckable(command.checkable);
    if (command.icon != nullptr) action->setIcon(themedIcon(QLatin1String(command.icon)));
    action->setIconVisibleInMenu(false);  // in menus the tick says what is on
    keep(*action, command.hint.isEmpty() ? action->iconText() : command.hint, command.keys);
    menu(command.menu).addAction(action);
    return *action;
}

void CommandTable::keep(QAction& action, const QString& hint, const QKeySequence& keys) {
    const Entry entry{&action, hint, keys};
    setKeys(entry, keys);
    m_entries.emplace(action.objectName(), entry);
    m_actions.push_back(&action);
    m_window.addAction(&action);  // keys work while no menu bar is to be seen
}

void CommandTable::adopt(CommandMenu which) {
    for (QAction* action : menu(which).actions()) {
        if (action->objectName().isEmpty() || m_entries.contains(action->objectName())) continue;
        const QKeySequence keys = action->shortcut();
        // Its tool tip ends with its keys, which a layout may change.
        const QString end = QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
        QString hint = action->toolTip();
        if (hint.endsWith(end)) hint.chop(end.size());
        keep(*action, hint, keys);
    }
}

void CommandTable::separate(CommandMenu which) {
    menu(which).addSeparator();
}

QAction* CommandTable::find(const QString& id) const {
    const auto found = m_entries.find(id);
    return found == m_entries.end() ? nullptr : found->second.action;
}

void CommandTable::trigger(const QString& id) {
    if (QAction* action = find(id); action != nullptr && action->isEnabled()) action->trigger();
}

void CommandTable::setHint(const QString& id, const QString& hint) {
    const auto found = m_entries.find(id);
    if (found == m_entries.end()) return;
    found->second.hint = hint;
    setKeys(found->second, found->second.action->shortcut());
}

QStringList CommandTable::bind(const std::map<QString, QKeySequence>& keys) {
    QStringList unknown;
    for (const auto& [id, sequence] : keys) {
        if (!m_entries.contains(id)) unknown += id;
    }
    for (const auto& [id, entry] : m_entries) {
        const auto own = keys.find(id);
        setKeys(entry, own == keys.end() ? entry.keys : own->second);
    }
    return unknown;
}

void CommandTable::setKeys(const Entry& entry, const QKeySequence& keys) {
    entry.action->setShortcut(keys);
    const QString text = keys.toString(QKeySequence::NativeText);
    entry.action->setToolTip(text.isEmpty() ? entry.hint : QStringLiteral("%1 (%2)").arg(entry.hint, text));
}

}  // namespace leitstand
