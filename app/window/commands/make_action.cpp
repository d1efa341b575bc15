#include "app/window/commands/make_action.h"

#include "widgets/painting/icons.h"

namespace leitstand {

QAction* makeAction(const ActionLook& look, QObject* parent) {
    auto* action = new QAction(look.text, parent);
    action->setObjectName(QLatin1String(look.name));
    action->setShortcut(look.keys);
    action->setCheckable(look.checkable);
    if (look.icon != nullptr) action->setIcon(themedIcon(QLatin1String(look.icon)));
    // In menus the tick shows what is on; an icon would hide it.
    action->setIconVisibleInMenu(false);
    const QString hint = look.hint.isEmpty() ? action->iconText() : look.hint;
    const QString keys = look.keys.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? hint : QStringLiteral("%1 (%2)").arg(hint, keys));
    return action;
}

}  // namespace leitstand
