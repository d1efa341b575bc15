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

/// One command that the operator can request.
struct Command {
    QString id;  ///< stable, named by layouts and pads; also the action's object name: "camera.recentre"
    CommandMenu menu = CommandMenu::View;
    QString text;            ///< in the menu, with its mnemonic
    QString hint = {};       ///< what it does, without its keys; empty: the text suffices
    QKeySequence keys = {};  ///< unless a layout binds others
    bool checkable = false;
    const char* icon = nullptr;  ///< of resources/icons
};

/// Holds every command of a window once, by its id. Menus, keys and pad buttons trigger the same action.
class CommandTable final : public QObject {
    Q_OBJECT
public:
    /// Adds the menus to the menu bar of @p window. Keys work in the whole window.
    explicit CommandTable(QMainWindow& window);

    /// Adds a command and returns its action. Ids are unique.
    QAction& add(const Command& command);
    /// Takes over the actions that others added to @p menu. Their object names are the ids.
    void adopt(CommandMenu menu);
    void separate(CommandMenu menu);
    /// Returns the menu, for entries that are no commands, such as submenus and exclusive groups.
    [[nodiscard]] QMenu& menu(CommandMenu menu) { return *m_menus.at(menu); }

    [[nodiscard]] QAction* find(const QString& id) const;  ///< null when there is none
    [[nodiscard]] const std::vector<QAction*>& all() const { return m_actions; }
    /// Triggers command @p id as if the operator had chosen it. Does nothing when it is unknown or disabled.
    void trigger(const QString& id);
    /// Sets the tooltip of @p id, to which its keys are appended.
    void setHint(const QString& id, const QString& hint);
    struct Refused {
        QStringList unknown;  ///< ids
        QStringList taken;    ///< "id: keys" that are no keys, belong to another command or are @p reserved
    };
    /// Binds @p keys by command id, as text ("Ctrl+K"; empty: none). All other commands, and the refused
    /// ones, get their default keys.
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
