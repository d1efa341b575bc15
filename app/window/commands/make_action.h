#pragma once

#include <QAction>
#include <QKeySequence>
#include <QString>

namespace leitstand {

/// How a command appears to the operator.
struct ActionLook {
    const char* name;  ///< object name, for tests
    QString text;      ///< text with its mnemonic
    QString hint;      ///< tooltip: what the command does, without its keys; empty: the text
    QKeySequence keys = {};
    const char* icon = nullptr;  ///< file in resources/icons, without ".svg"; null: no icon
    bool checkable = false;
};

/// Returns an action that exists as long as @p parent. Its tooltip ends with its keys.
[[nodiscard]] QAction* makeAction(const ActionLook& look, QObject* parent);

}  // namespace leitstand
