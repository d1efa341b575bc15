#pragma once

#include <QAction>
#include <QKeySequence>
#include <QString>

namespace leitstand {

/// What a command looks like to the operator.
struct ActionLook {
    const char* name;  ///< object name, for tests
    QString text;      ///< with its mnemonic
    QString hint;      ///< what it does, without its keys; empty: the text says it all
    QKeySequence keys = {};
    const char* icon = nullptr;  ///< of resources/icons
    bool checkable = false;
};

/// An action that lives as long as @p parent; its tool tip ends with its keys.
[[nodiscard]] QAction* makeAction(const ActionLook& look, QObject* parent);

}  // namespace leitstand
