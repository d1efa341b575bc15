#include "widgets/review/finds_panel.h"

#include <utility>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace leitstand {
namespace {

enum Column { Name, Status, Found, Details };

}  // namespace

FindsPanel::FindsPanel(QWidget* parent)
    : QWidget(parent),
      m_list(new QTreeWidget(this)),
      m_title(new QLabel(this)),
      m_calm(new QLabel(tr("Nothing was found yet"), this)) {
    setAccessibleName(tr("Victims and other finds"));
    m_list->setObjectName(QStringLiteral("finds"));
    m_list->setAccessibleName(tr("Finds; Return goes to the moment when the chosen one was found"));
    m_list->setHeaderLabels({tr("Find"), tr("Status"), tr("Found"), tr("Details")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
    m_calm->setProperty("muted", true);
    m_calm->setAlignment(Qt::AlignCenter);
    QToolButton* const note = button("note", tr("Note…"), tr("Writes a note about this moment"));
    m_undo = button("undoCorrection", tr("Undo"), tr("Takes back what was written last in this review"));
    m_edit = button("editFind", tr("Form…"), tr("The chosen find's form: what is known of it"));
    m_confirm = button("confirmFind", tr("Confirm"), tr("The chosen find is one"));
    m_discard = button("discardFind", tr("Discard"), tr("The chosen find is none"));
    const auto onChosen = [this](QToolButton* from, auto signal) {
        connect(from, &QToolButton::clicked, this, [this, signal] {
            if (const auto find = chosen()) emit(this->*signal)(*find);
        });
    };
    onChosen(m_edit, &FindsPanel::formWanted);
    onChosen(m_confirm, &FindsPanel::confirmed);
    onChosen(m_discard, &FindsPanel::discarded);
    connect(note, &QToolButton::clicked, this, &FindsPanel::noteWanted);
    connect(m_undo, &QToolButton::clicked, this, &FindsPanel::undone);
    connect(m_list, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        emit sought(m_rows[static_cast<std::size_t>(m_list->indexOfTopLevelItem(item))].found);
    });
    connect(m_list, &QTreeWidget::currentItemChanged, this, [this] { refresh(); });

    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 4, 4, 0);
    head->addWidget(m_title, 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 4, 4);
    for (QToolButton* one : {m_confirm, m_discard, m_edit, m_undo, note}) foot->addWidget(one);
    foot->addStretch(1);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addLayout(head);
    rows->addWidget(m_list, 1);
    rows->addWidget(m_calm, 1);
    rows->addLayout(foot);
    setUndoable(false);
    refresh();
}

QToolButton* FindsPanel::button(const char* name, const QString& text, const QString& hint) {
    auto* made = new QToolButton(this);
    made->setObjectName(QLatin1String(name));
    made->setText(text);
    made->setToolTip(hint);
    made->setAccessibleName(hint);
    made->setProperty("quiet", true);
    made->setFocusPolicy(Qt::TabFocus);
    return made;
}

std::optional<FindKey> FindsPanel::chosen() const {
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    return row < 0 ? std::nullopt : std::optional(m_rows[static_cast<std::size_t>(row)].key);
}

void FindsPanel::choose(const FindKey& find) {
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (m_rows[row].key == find) m_list->setCurrentItem(m_list->topLevelItem(static_cast<int>(row)));
    }
}

void FindsPanel::setUndoable(bool on) {
    m_undo->setEnabled(on);
}

void FindsPanel::show(std::vector<FindRow> rows) {
    if (rows == m_rows) return;
    const auto before = chosen();
    m_list->clear();
    m_rows = std::move(rows);
    for (const FindRow& row : m_rows) {
        auto* item = new QTreeWidgetItem(m_list, {row.name, row.status, row.since, row.details});
        item->setToolTip(Name, tr("%1 at %2").arg(row.name, row.place));
        item->setToolTip(Details, row.details);
        if (row.tone != Tone::Muted) continue;
        for (int column = Name; column <= Details; ++column)
            item->setForeground(column, palette().placeholderText());
    }
    if (before) choose(*before);
    refresh();
}

void FindsPanel::refresh() {
    m_list->setVisible(!m_rows.empty());
    m_calm->setVisible(m_rows.empty());
    m_title->setText(m_rows.empty() ? tr("Finds") : tr("Finds · %1").arg(m_rows.size()));
    for (QToolButton* one : {m_confirm, m_discard, m_edit}) one->setEnabled(chosen().has_value());
}

}  // namespace leitstand
