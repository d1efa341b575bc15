#pragma once

#include <map>
#include <vector>

#include <QKeySequence>
#include <QObject>
#include <QString>
#include <QStringList>

class QAction;
class QMainWindow;
class QMenu;

namespace leitstand {

/// The menus of the live window, from left to right.
enum class CommandMenu { Mission, Robot, Cameras, Map, View, Help };

/// One thing that the operator can ask for.
struct Command {
    QString id;  ///< stable: layouts and pads name it; also the action's object name: "camera.recentre"
    CommandMenu menu = CommandMenu::View;
    QString text;            ///< in the menu, with its mnemonic
    QString hint = {};       ///< what it does, without its keys; empty: the text says it all
    QKeySequence keys = {};  ///< unless a layout says otherwise
    bool checkable = false;
    const char* icon = nullptr;  ///< of resources/icons
};

/// Every command of a window once, by its id: menus, keys and pad buttons mean the same action.
class CommandTable final : public QObject {
    Q_OBJECT
public:
    /// Menus go into @p window's menu bar, keys work in all of it.
    explicit CommandTable(QMainWindow& window);

    /// The new command's action; ids are unique.
    QAction& add(const Command& command);
    /// Takes over what others put into @p menu: their object names are the ids.
    void adopt(CommandMenu menu);
    void separate(CommandMenu menu);
    /// For what is no command of ours, such as submenus and exclusive groups.
    [[nodiscard]] QMenu& menu(CommandMenu menu) { return *m_menus.at(menu); }

    [[nodiscard]] QAction* find(const QString& id) const;  ///< null when there is none
    [[nodiscard]] const std::vector<QAction*>& all() const { return m_actions; }
    /// As if the operator had chosen it in the menu; nothing when it is unknown or disabled.
    void trigger(const QString& id);
    /// What the tooltip of @p id says from now on, before its keys.
    void setHint(const QString& id, const QString& hint);
    struct Refused {
        QStringList unknown;  ///< ids
        QStringList taken;    ///< "id: keys" that are none, mean another command or are @p reserved
    };
    /// Keys of commands by id, as text ("Ctrl+K"; empty: none); all others, and what is refused, have those
    /// of their own.
    Refused bind(const std::map<QString, QString>& keys, const std::vector<Qt::Key>& reserved);

private:
    struct Entry {
        QAction* action;
        QString hint;
        QKeySequence keys;
    };
    void keep(QAction& action, const QString& hint, const QKeySequence& keys);
    static void setKeys(const Entry& entry, const QKeySequence& keys);

    QMainWindow& m_window;
    std::map<CommandMenu, QMenu*> m_menus;
    std::map<QString, Entry> m_entries;
    std::vector<QAction*> m_actions;
};

}  // namespace leitstand
