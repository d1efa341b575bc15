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

/// A command that the operator can trigger.
struct Command {
    /// "camera.recentre": for layouts and gamepads, never changes; also the action's objectName().
    QString id;
    CommandMenu menu = CommandMenu::View;
    QString text;            ///< text in the menu, with its mnemonic
    QString hint = {};       ///< tooltip: what the command does, without its keys; empty: the text
    QKeySequence keys = {};  ///< default keys; a layout may bind others
    bool checkable = false;
    const char* icon = nullptr;  ///< file in resources/icons, without ".svg"; null: no icon
};

/// Holds every command of a window once, by its id. Menus, keys and pad buttons all trigger the same action.
class CommandTable final : public QObject {
    Q_OBJECT
public:
    /// Adds the menus to the menu bar of @p window. Keys work in the whole window.
    explicit CommandTable(QMainWindow& window);

    /// Adds a command and returns its action. Ids are unique.
    QAction& add(const Command& command);
    /// Also manages the actions that were added to @p menu without add(). Their object names become their
    /// ids; actions without a name are left out.
    void adopt(CommandMenu menu);
    void separate(CommandMenu menu);
    /// Returns the menu, for entries that are no commands, such as submenus and exclusive groups.
    [[nodiscard]] QMenu& menu(CommandMenu menu) { return *m_menus.at(menu); }

    [[nodiscard]] QAction* find(const QString& id) const;  ///< null: there is none
    [[nodiscard]] const std::vector<QAction*>& all() const { return m_actions; }
    /// Triggers command @p id as if the operator had chosen it. Does nothing when it is unknown or disabled.
    void trigger(const QString& id);
    /// Sets the tooltip of command @p id. The table appends the keys of the command.
    void setHint(const QString& id, const QString& hint);
    struct Refused {
        QStringList unknown;  ///< ids that belong to no command
        /// "id: keys": keys that are invalid, belong to another command, or are in @p reserved.
        QStringList taken;
    };
    /// Binds @p keys: by command id, as text ("Ctrl+K"; empty: no keys). All other commands get their default
    /// keys, and so do commands whose keys are refused. Returns what was refused. @p reserved: keys that no
    /// command may have.
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
