#pragma once

#include <vector>

#include <QObject>

#include "app/window/commands/key_list.h"

class QAction;
class QDialog;
class QMenu;
class QWidget;

namespace leitstand {

/// The Help menu: the keys of the program, and its version. Its dialogs are not modal, since robots may be
/// driving.
class HelpCommands final : public QObject {
    Q_OBJECT
public:
    /// Lists the keys of all actions in the menus of @p window, and those of the map and the lists of scans.
    explicit HelpCommands(QWidget& window);
    /// Lists @p others in addition to the keys of the menus.
    HelpCommands(QWidget& window, KeyColumn others);

    /// Puts the commands into @p menu.
    void fill(QMenu& menu);

private:
    void showKeys();
    void showAbout();
    /// Brings the dialog @p name to the front. Returns false when it is not open.
    bool raise(const char* name) const;
    static void open(QDialog& dialog);

    QWidget& m_window;
    const KeyColumn m_others;
    QAction* m_keys;
    QAction* m_about;
};

}  // namespace leitstand
