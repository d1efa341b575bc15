#include "app/window/commands/command_table.h"

#include <algorithm>

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "widgets/painting/icons.h"

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
    action->setIconVisibleInMenu(false);  // in menus the tick shows what is on
    keep(*action, command.hint.isEmpty() ? action->iconText() : command.hint, command.keys);
    menu(command.menu).addAction(action);
    return *action;
}

void CommandTable::keep(QAction& action, const QString& hint, const QKeySequence& keys) {
    const Entry entry{&action, hint, keys};
    setKeys(entry, keys);
    m_entries.emplace(action.objectName(), entry);
    m_actions.push_back(&action);
    m_window.addAction(&action);  // keys also work while the menu bar is hidden
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

CommandTable::Refused CommandTable::bind(const std::map<QString, QString>& keys,
                                         const std::vector<Qt::Key>& reserved) {
    Refused refused;
    std::map<QString, QKeySequence> meant;
    for (const auto& [id, entry] : m_entries) meant[id] = entry.keys;
    std::map<QString, QString> own;
    for (const auto& [id, text] : keys) {
        if (!meant.contains(id)) {
            refused.unknown += id;
            continue;
        }
        meant[id] = QKeySequence::fromString(text);
        if (!text.isEmpty()) own[id] = text;
    }
    const auto counts = [&](const QString& id) {
        const QKeySequence& wanted = meant[id];
        return !wanted.isEmpty() && wanted[0].key() != Qt::Key_unknown &&
               std::none_of(reserved.begin(), reserved.end(),
                            [&](Qt::Key key) { return wanted == QKeySequence(key); }) &&
               std::none_of(meant.begin(), meant.end(),
                            [&](const auto& other) { return other.first != id && other.second == wanted; });
    };
    // A refused command gets its own keys back, which another one may want.
    for (auto one = own.begin(); one != own.end();) {
        if (counts(one->first)) {
            ++one;
            continue;
        }
        refused.taken += QStringLiteral("%1: %2").arg(one->first, one->second);
        meant[one->first] = m_entries.at(one->first).keys;
        own.erase(one);
        one = own.begin();
    }
    for (const auto& [id, sequence] : meant) setKeys(m_entries.at(id), sequence);
    return refused;
}

void CommandTable::setKeys(const Entry& entry, const QKeySequence& keys) {
    if (entry.action->shortcut() != keys) entry.action->setShortcut(keys);  // it may have further ones
    const QString text = keys.toString(QKeySequence::NativeText);
    entry.action->setToolTip(text.isEmpty() ? entry.hint : QStringLiteral("%1 (%2)").arg(entry.hint, text));
}

}  // namespace leitstand
