#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/services/score/score_board.h"
#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

class FindsFeature;
class ReviewBridge;
class ScorePane;

/// The hand-in of a reviewed mission: the estimated score at the moment that is shown ("score"), and the
/// folder for the judges, with the corrections of the review.
class HandInFeature final : public QObject {
    Q_OBJECT
public:
    HandInFeature(const ReviewContext& context, FindsFeature& finds);

    [[nodiscard]] QWidget& pane() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void askForFolder();
    void showProgress();
    void showScore();

    ViewContext m_context;
    ReviewBridge& m_bridge;
    FindsFeature& m_finds;
    ScoreBoard m_board;
    ScorePane* m_score;
    QAction* m_write = nullptr;
    QTimer m_soon;  ///< runs until the score is estimated again
};

}  // namespace leitstand
