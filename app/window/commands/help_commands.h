#pragma once

#include <vector>

#include <QObject>

#include "app/window/commands/key_list.h"

class QAction;
class QDialog;
class QMenu;
class QWidget;

namespace leitstand {

/// What the program is and which keys it knows: the Help menu. Its dialogs are not modal: robots may be
/// driving.
class HelpCommands final : public QObject {
    Q_OBJECT
public:
    /// The keys listed are those of all actions of @p window's menus, and of the map and lists of scans.
    explicit HelpCommands(QWidget& window);
    /// Beside those of the menus are @p others.
    HelpCommands(QWidget& window, KeyColumn others);

    /// Puts the commands into @p menu.
    void fill(QMenu& menu);

private:
    void showKeys();
    void showAbout();
    /// Brings the dialog @p name to the front; false: it is not open.
    bool raise(const char* name) const;
    static void open(QDialog& dialog);

    QWidget& m_window;
    const KeyColumn m_others;
    QAction* m_keys;
    QAction* m_about;
};

}  // namespace leitstand
