#include "app/window/commands/help_commands.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QVBoxLayout>

#include "app/window/commands/make_action.h"

namespace leitstand {
namespace {

using Line = std::pair<QString, QString>;

/// Keys and meanings of all actions that have keys, without repetition.
std::vector<Line> actionKeys(const QWidget& window) {
    std::vector<Line> lines;
    for (const QMenu* menu : window.findChildren<QMenu*>()) {
        for (const QAction* action : menu->actions()) {
            const Line line{action->shortcut().toString(QKeySequence::NativeText), action->iconText()};
            const bool known = std::find(lines.begin(), lines.end(), line) != lines.end();
            if (!line.first.isEmpty() && !known) lines.push_back(line);
        }
    }
    return lines;
}

std::vector<Line> mapKeys() {
    return {
        {HelpCommands::tr("Left button"), HelpCommands::tr("turns the map; while measuring, picks a point")},
        {HelpCommands::tr("Middle, Shift+left"), HelpCommands::tr("shifts the map")},
        {HelpCommands::tr("Wheel, right button"), HelpCommands::tr("zooms")},
        {HelpCommands::tr("Arrows, +, −"), HelpCommands::tr("turn and zoom; with Shift they shift")},
        {HelpCommands::tr("Esc"), HelpCommands::tr("ends measuring")},
        {HelpCommands::tr("Space"), HelpCommands::tr("in the scans list: shows or hides the scan")},
        {HelpCommands::tr("Tab, Shift+Tab"), HelpCommands::tr("next and previous field")},
    };
}

void addColumn(QGridLayout& grid, int column, const QString& title, const std::vector<Line>& lines) {
    auto* head = new QLabel(title);
    head->setProperty("muted", true);
    grid.addWidget(head, 0, column, 1, 2);
    int row = 1;
    for (const auto& [keys, meaning] : lines) {
        grid.addWidget(new QLabel(keys), row, column);
        grid.addWidget(new QLabel(meaning), row++, column + 1);
    }
}

}  // namespace

HelpCommands::HelpCommands(QWidget& window) : QObject(&window), m_window(window) {
    m_keys = makeAction({"keys", tr("&Keys"), tr("Lists all keys"), QKeySequence(Qt::Key_F1)}, this);
    m_about = makeAction({"about", tr("&About Leitstand"), {}}, this);
    connect(m_keys, &QAction::triggered, this, &HelpCommands::showKeys);
    connect(m_about, &QAction::triggered, this, &HelpCommands::showAbout);
}

void HelpCommands::fill(QMenu& menu) {
    menu.addActions({m_keys, m_about});
}

void HelpCommands::showKeys() {
    auto* dialog = new QDialog(&m_window);
    dialog->setObjectName(QStringLiteral("keysDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Keys"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(5);
    addColumn(*grid, 0, tr("Commands"), actionKeys(m_window));
    grid->setColumnMinimumWidth(2, 24);
    addColumn(*grid, 3, tr("Map and lists"), mapKeys());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addLayout(grid);
    layout->addSpacing(8);
    layout->addWidget(buttons);
    dialog->open();
}

void HelpCommands::showAbout() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Leitstand"),
                                tr("Leitstand %1").arg(QCoreApplication::applicationVersion()),
                                QMessageBox::Close, &m_window);
    box->setObjectName(QStringLiteral("aboutBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(
        tr("The operator station for rescue robots: registers 3D laser scans into one map and shows it, "
           "after the "
           "methods of the RoboCup Rescue team Deutschland1.\n\nApache License 2.0"));
    box->open();
}

}  // namespace leitstand
