#include "app/window/commands/language_commands.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QString>

#include "app/language/language.h"
#include "app/window/commands/command_table.h"

namespace leitstand {

void addLanguageCommands(CommandTable& commands, const std::function<void(const QString& code)>& choose) {
    commands.separate(CommandMenu::View);
    auto* group = new QActionGroup(&commands);
    for (const Language& language : languages()) {
        QAction& action =
            commands.add({.id = QStringLiteral("language.") + language.code,
                          .menu = CommandMenu::View,
                          .text = language.name,
                          .hint = QCoreApplication::translate("leitstand::Language",
                                                              "The window is made anew in this language"),
                          .checkable = true});
        group->addAction(&action);
        action.setChecked(language.code == presentLanguage());
        QObject::connect(&action, &QAction::triggered, &commands,
                         [choose, code = language.code] { choose(code); });
    }
}

}  // namespace leitstand
