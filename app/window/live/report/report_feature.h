#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QString>

#include "app/session/score/score_board.h"
#include "app/window/live/live_context.h"

class QAction;

namespace leitstand {

class ReportKeeper;
class ScorePane;
struct LiveMoment;

/// The hand-in (design, section 7): what is known of the mission, the estimate of its score ("score"), and
/// the judges' folder, written at once and every minute while the mission runs.
class ReportFeature final : public QObject {
    Q_OBJECT
public:
    explicit ReportFeature(const LiveContext& context);
    ~ReportFeature() override;

signals:
    void told(const QString& text);

private:
    void addCommands();
    void askForData();
    void askForFolder();
    void keep(const QString& folder);
    void endKeeping();
    void show(const LiveMoment& moment);

    LiveContext m_context;
    ScoreBoard m_board;
    ScorePane* m_score;
    QAction* m_keep = nullptr;
    std::unique_ptr<ReportKeeper> m_keeper;
    std::vector<std::unique_ptr<ReportKeeper>> m_ended;  ///< that may still be writing
    int m_sinceScore = 0;                                ///< ticks
};

}  // namespace leitstand
