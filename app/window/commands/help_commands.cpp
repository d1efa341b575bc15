#include "app/window/commands/help_commands.h"

#include <utility>

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMessageBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "app/window/commands/make_action.h"

namespace leitstand {
namespace {

constexpr double MostOfWindow = 0.9;  ///< part of the window that the list of keys may cover

KeyColumn mapKeys() {
    return {HelpCommands::tr("Map and lists"),
            {
                {HelpCommands::tr("Left button"),
                 HelpCommands::tr("turns the map; while measuring, picks a point")},
                {HelpCommands::tr("Middle, Shift+left"), HelpCommands::tr("shifts the map")},
                {HelpCommands::tr("Wheel, right button"), HelpCommands::tr("zooms")},
                {HelpCommands::tr("Arrows, +, −"), HelpCommands::tr("turn and zoom; with Shift they shift")},
                {HelpCommands::tr("Esc"), HelpCommands::tr("ends measuring")},
                {HelpCommands::tr("Space"), HelpCommands::tr("in the scans list: shows or hides the scan")},
                {HelpCommands::tr("Tab, Shift+Tab"), HelpCommands::tr("next and previous field")},
            }};
}

}  // namespace

HelpCommands::HelpCommands(QWidget& window) : HelpCommands(window, mapKeys()) {}

HelpCommands::HelpCommands(QWidget& window, KeyColumn others)
    : QObject(&window), m_window(window), m_others(std::move(others)) {
    m_keys = makeAction({"keys", tr("&Keys"), tr("Lists all keys"), QKeySequence(Qt::Key_F1)}, this);
    m_about = makeAction({"about", tr("&About Leitstand"), {}}, this);
    connect(m_keys, &QAction::triggered, this, &HelpCommands::showKeys);
    connect(m_about, &QAction::triggered, this, &HelpCommands::showAbout);
}

void HelpCommands::fill(QMenu& menu) {
    menu.addActions({m_keys, m_about});
}

bool HelpCommands::raise(const char* name) const {
    auto* const dialog = m_window.findChild<QDialog*>(QLatin1String(name));
    if (dialog == nullptr || !dialog->isVisible()) return false;
    dialog->raise();
    dialog->activateWindow();
    return true;
}

void HelpCommands::open(QDialog& dialog) {
    dialog.setAttribute(Qt::WA_DeleteOnClose);
    dialog.setModal(false);
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

void HelpCommands::showKeys() {
    if (raise("keysDialog")) return;
    auto* dialog = new QDialog(&m_window);
    dialog->setObjectName(QStringLiteral("keysDialog"));
    dialog->setWindowTitle(tr("Keys"));
    auto* area = new QScrollArea(dialog);  // a low screen may not have room for all lines
    area->setAccessibleName(tr("Keys"));
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setWidget(makeKeyTable({{tr("Commands"), commandKeys(m_window)}, m_others}));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(area);
    layout->addSpacing(8);
    layout->addWidget(buttons);
    const int bar = area->verticalScrollBar()->sizeHint().width();
    const QSize whole = area->widget()->sizeHint() + QSize(bar, bar);
    const QSize rest = dialog->sizeHint() - area->sizeHint();
    dialog->resize((whole + rest).boundedTo(m_window.size() * MostOfWindow));
    open(*dialog);
}

void HelpCommands::showAbout() {
    if (raise("aboutBox")) return;
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Leitstand"),
                                tr("Leitstand %1").arg(QCoreApplication::applicationVersion()),
                                QMessageBox::Close, &m_window);
    box->setObjectName(QStringLiteral("aboutBox"));
    box->setInformativeText(
        tr("The operator station for rescue robots: registers 3D laser scans into one map and shows it, "
           "after the "
           "methods of the RoboCup Rescue team Deutschland1.\n\nApache License 2.0"));
    open(*box);
}

}  // namespace leitstand
