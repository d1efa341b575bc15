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

/// Shows the estimated score of the mission: the sum, the points of each find, and what would add points.
class ScorePane final : public QWidget {
    Q_OBJECT
public:
    explicit ScorePane(QWidget* parent = nullptr);

    void show(const ScoreText& text);
    using QWidget::show;
    /// Adds a button below the estimate for each of @p commands.
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
