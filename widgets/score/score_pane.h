#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/score/score_text.h"

class QAction;
class QFormLayout;
class QLabel;
class QLayout;
class QScrollArea;
class QVBoxLayout;

namespace leitstand {

/// What the mission would bring now: the sum, what each find adds, what would bring more.
class ScorePane final : public QWidget {
    Q_OBJECT
public:
    explicit ScorePane(QWidget* parent = nullptr);

    void show(const ScoreText& text);
    using QWidget::show;
    /// Buttons for these commands, below the estimate.
    void setCommands(const std::vector<QAction*>& commands);

    [[nodiscard]] QSize sizeHint() const override { return {280, 240}; }

private:
    void fill(QFormLayout& list, const std::vector<ScoreLine>& lines);

    ScoreText m_text;
    QLabel *m_score, *m_left, *m_rules, *m_calm, *m_more;
    QScrollArea* m_lines;
    QFormLayout *m_finds, *m_advice;
    QLayout* m_buttons;
};

}  // namespace leitstand
