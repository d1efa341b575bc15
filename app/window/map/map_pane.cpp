#include "app/window/map/map_pane.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/window/map/look_bar.h"
#include "widgets/map_view/map_view.h"
#include "widgets/painting/elided_label.h"

namespace leitstand {
namespace {

constexpr int ToolGap = 8, ToolSpacing = 6, IconSize = 20, HeadMargin = 10, HeadSpacing = 14;  ///< [px]

void setTone(QLabel& label, Tone tone) {
    const QVariant before = label.property("attention");
    if (before.isValid() && before.toBool() == (tone == Tone::Attention)) return;  // styling is expensive
    label.setProperty("attention", tone == Tone::Attention);
    label.setProperty("muted", tone != Tone::Attention);
    label.style()->unpolish(&label);
    label.style()->polish(&label);
}

QToolButton* toolButton(QAction* action, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setObjectName(QStringLiteral("tool_") + action->objectName());
    button->setAccessibleName(action->iconText());
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setIconSize({IconSize, IconSize});
    button->setProperty("tool", true);
    return button;
}

}  // namespace

MapPane::MapPane(ViewState& state, QWidget* parent)
    : QWidget(parent),
      m_view(new MapView(this)),
      m_title(new QLabel(this)),
      m_result(new ElidedLabel(this)),
      m_help(help()),
      m_stage(new QGridLayout) {
    m_view->setObjectName(QStringLiteral("map"));
    m_view->setAccessibleName(tr("3D map"));
    m_stage->setContentsMargins(0, 0, 0, 0);
    m_stage->addWidget(m_view, 0, 0);
    m_stage->addWidget(m_help, 0, 0, Qt::AlignCenter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(header(state));
    layout->addLayout(m_stage, 1);
}

QWidget* MapPane::header(ViewState& state) {
    auto* head = new QWidget(this);
    head->setObjectName(QStringLiteral("mapHead"));
    head->setAttribute(Qt::WA_StyledBackground);
    auto* rows = new QVBoxLayout(head);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    auto* line = new QHBoxLayout;
    line->setContentsMargins(HeadMargin, 8, HeadMargin, 7);
    line->setSpacing(HeadSpacing);
    m_title->setObjectName(QStringLiteral("mapTitle"));
    m_result->setObjectName(QStringLiteral("mapResult"));
    m_result->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    line->addWidget(m_title);
    line->addWidget(m_result, 1);
    rows->addLayout(line);
    rows->addWidget(new LookBar(state, head));
    return head;
}

QLabel* MapPane::help() {
    auto* label = new QLabel(
        tr("Drop scans, a folder of scans or a mission here,\nor choose File ▸ Open scans (Ctrl+O) or Open "
           "folder (Ctrl+Shift+O)\n\nF1 lists all keys"),
        this);
    label->setObjectName(QStringLiteral("help"));
    label->setAlignment(Qt::AlignCenter);
    label->setProperty("muted", true);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    return label;
}

void MapPane::setTools(const QList<QAction*>& tools) {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(10, 6, 0, 0);
    layout->setSpacing(ToolSpacing);
    for (QAction* action : tools) {
        if (action == nullptr) {
            layout->addSpacing(ToolGap);
        } else {
            layout->addWidget(toolButton(action, column));
        }
    }
    m_stage->addWidget(column, 0, 0, Qt::AlignLeft | Qt::AlignTop);
}

void MapPane::setStoreys(QWidget& row) {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 10, 0);
    layout->addWidget(&row);
    m_stage->addWidget(column, 0, 0, Qt::AlignRight | Qt::AlignVCenter);
}

void MapPane::setSummary(const MapSummary& summary) {
    m_summary = summary;
    showTexts();
    m_title->setToolTip(summary.title);
    m_result->setToolTip(summary.result + QLatin1Char('\n') + summary.hint);
    setTone(*m_result, summary.tone);
    m_view->setStale(summary.stale);
}

void MapPane::showTexts() {
    const int wanted = m_title->fontMetrics().horizontalAdvance(m_summary.title) +
                       m_result->fontMetrics().horizontalAdvance(m_summary.result);
    const bool brief = wanted + 2 * HeadMargin + HeadSpacing > width();
    const auto chosen = [brief](const QString& text, const QString& briefText) {
        return brief && !briefText.isEmpty() ? briefText : text;
    };
    m_title->setText(chosen(m_summary.title, m_summary.briefTitle));
    m_result->setText(chosen(m_summary.result, m_summary.briefResult));
}

void MapPane::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showTexts();
}

void MapPane::setHelpVisible(bool visible) {
    m_help->setVisible(visible);
}

}  // namespace leitstand
