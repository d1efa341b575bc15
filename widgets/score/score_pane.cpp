#include "widgets/score/score_pane.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/mission/state/find_state.h"
#include "widgets/tables/button_flow.h"
#include "widgets/tables/command_buttons.h"

namespace leitstand {

ScorePane::ScorePane(QWidget* parent)
    : QWidget(parent),
      m_score(new QLabel(this)),
      m_left(new QLabel(this)),
      m_rules(new QLabel(this)),
      m_calm(new QLabel(tr("Nothing to score yet: what a find brings is listed here"), this)),
      m_more(new QLabel(tr("More would bring"))),
      m_lines(new QScrollArea(this)),
      m_finds(new QFormLayout),
      m_advice(new QFormLayout),
      m_buttons(new ButtonFlow) {
    setAccessibleName(tr("Estimate of the score"));
    setToolTip(tr("An estimate: judges look at the map, which counts as good here"));
    QFont large = m_score->font();
    large.setPixelSize(20);
    large.setBold(true);
    m_score->setFont(large);
    m_rules->setProperty("muted", true);
    m_rules->setWordWrap(true);
    m_calm->setProperty("muted", true);
    m_calm->setAlignment(Qt::AlignCenter);
    m_calm->setWordWrap(true);
    m_more->setProperty("muted", true);
    m_more->hide();  // until there is something
    auto* head = new QHBoxLayout;
    head->addWidget(m_score, 1);
    head->addWidget(m_left);
    auto* lists = new QWidget;
    auto* columns = new QVBoxLayout(lists);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->addLayout(m_finds);
    columns->addWidget(m_more);
    columns->addLayout(m_advice);
    columns->addStretch(1);
    for (QFormLayout* list : {m_finds, m_advice}) {
        list->setVerticalSpacing(2);
        list->setHorizontalSpacing(12);
        list->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    }
    m_lines->setObjectName(QStringLiteral("scoreLines"));
    m_lines->setWidget(lists);
    m_lines->setWidgetResizable(true);
    m_lines->setFrameShape(QFrame::NoFrame);
    m_lines->setFocusPolicy(Qt::TabFocus);
    m_lines->setAccessibleName(tr("What each find adds, and what would bring more"));
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(8, 6, 8, 6);
    rows->addLayout(head);
    rows->addWidget(m_rules);
    rows->addWidget(m_lines, 1);
    rows->addWidget(m_calm, 1);
    m_buttons->setSpacing(2);
    rows->addLayout(m_buttons);
    m_lines->hide();  // until there is something
}

void ScorePane::setCommands(const std::vector<QAction*>& commands) {
    addCommandButtons(*m_buttons, commands, *this);
}

void ScorePane::fill(QFormLayout& list, const std::vector<ScoreLine>& lines) {
    while (list.rowCount() > 0) list.removeRow(0);
    for (const ScoreLine& line : lines) {
        auto* what = new QLabel(line.what);
        auto* points = new QLabel(line.points);
        points->setAlignment(Qt::AlignRight);
        what->setProperty("muted", line.tone == Tone::Muted);
        what->setProperty("attention", line.tone == Tone::Attention);
        list.addRow(what, points);
        if (line.items.isEmpty()) continue;
        auto* items = new QLabel(line.items);
        items->setProperty("muted", true);
        items->setWordWrap(true);
        items->setIndent(12);
        list.addRow(items);
    }
}

void ScorePane::show(const ScoreText& text) {
    if (text == m_text) return;
    m_text = text;
    m_score->setText(text.score);
    m_left->setText(text.left);
    m_rules->setText(text.rules);
    fill(*m_finds, text.finds);
    fill(*m_advice, text.advice);
    m_more->setVisible(!text.advice.empty());
    const bool calm = text.finds.empty() && text.advice.empty();
    m_calm->setVisible(calm);
    m_lines->setVisible(!calm);
}

}  // namespace leitstand
