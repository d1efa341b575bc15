#include "app/window/commands/language_commands.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QString>

#include "app/language/language.h"
#include "app/window/commands/command_table.h"

namespace leitstand {

namespace {

using Choose = std::function<void(const QString& code)>;

QString idOf(const Language& language) {
    return QStringLiteral("language.") + language.code;
}

QString hint() {
    return QCoreApplication::translate("leitstand::Language", "The window is made again in this language");
}

void connectChoice(QAction& action, QActionGroup& group, const Language& language, const Choose& choose) {
    group.addAction(&action);
    action.setChecked(language.code == presentLanguage());
    QObject::connect(&action, &QAction::triggered, &group, [choose, code = language.code] { choose(code); });
}

}  // namespace

void addLanguageCommands(CommandTable& commands, const Choose& choose) {
    commands.separate(CommandMenu::View);
    auto* group = new QActionGroup(&commands);
    for (const Language& language : languages()) {
        QAction& action = commands.add({.id = idOf(language),
                                        .menu = CommandMenu::View,
                                        .text = language.name,
                                        .hint = hint(),
                                        .checkable = true});
        connectChoice(action, *group, language, choose);
    }
}

void addLanguages(QMenu& menu, const Choose& choose) {
    menu.addSeparator();
    auto* group = new QActionGroup(&menu);
    for (const Language& language : languages()) {
        QAction* action = menu.addAction(language.name);
        action->setObjectName(idOf(language));
        action->setToolTip(hint());
        action->setStatusTip(hint());
        action->setCheckable(true);
        connectChoice(*action, *group, language, choose);
    }
}

}  // namespace leitstand
