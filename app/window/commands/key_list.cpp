#include "app/window/commands/key_list.h"

#include <algorithm>

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>

namespace leitstand {
namespace {

/// Returns a menu's text without its mnemonic: that of "&Open" or "開く(&O)".
QString plain(QString text) {
    static const QRegularExpression aside(QStringLiteral("\\(&.\\)"));
    return text.remove(aside).remove(QLatin1Char('&')).trimmed();
}

KeyLine lineOf(const QAction& action) {
    const QString text = action.text();
    QString keys = action.shortcut().toString(QKeySequence::NativeText);
    if (keys.isEmpty()) keys = text.section(QLatin1Char('\t'), 1);
    return {keys, plain(text.section(QLatin1Char('\t'), 0, 0))};
}

}  // namespace

std::vector<KeyLine> commandKeys(const QWidget& window) {
    std::vector<KeyLine> lines;
    for (const QMenu* menu : window.findChildren<QMenu*>()) {
        for (const QAction* action : menu->actions()) {
            if (!action->isVisible()) continue;
            const KeyLine line = lineOf(*action);
            const bool known = std::find(lines.begin(), lines.end(), line) != lines.end();
            if (!line.keys.isEmpty() && !known) lines.push_back(line);
        }
    }
    return lines;
}

QWidget* makeKeyTable(const std::vector<KeyColumn>& columns) {
    auto* table = new QWidget;
    auto* beside = new QHBoxLayout(table);
    beside->setContentsMargins(0, 0, 0, 0);
    beside->setSpacing(24);
    for (const KeyColumn& column : columns) {
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(16);
        grid->setVerticalSpacing(5);
        auto* head = new QLabel(column.title);
        head->setProperty("muted", true);
        grid->addWidget(head, 0, 0, 1, 2);
        int row = 1;
        for (const auto& [keys, meaning] : column.lines) {
            grid->addWidget(new QLabel(keys), row, 0);
            grid->addWidget(new QLabel(meaning), row++, 1);
        }
        grid->setRowStretch(row, 1);
        beside->addLayout(grid);
    }
    return table;
}

}  // namespace leitstand
