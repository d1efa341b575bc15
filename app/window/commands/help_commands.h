#pragma once

#include <QObject>

class QAction;
class QMenu;
class QWidget;

namespace leitstand {

/// What the program is and which keys it knows: the Help menu.
class HelpCommands final : public QObject {
    Q_OBJECT
public:
    /// The keys listed are those of all actions of @p window's menus.
    explicit HelpCommands(QWidget& window);

    /// Puts the commands into @p menu.
    void fill(QMenu& menu);

private:
    void showKeys();
    void showAbout();

    QWidget& m_window;
    QAction* m_keys;
    QAction* m_about;
};

}  // namespace leitstand
