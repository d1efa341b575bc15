#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include <QObject>
#include <QString>

#include "app/services/score/score_board.h"
#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

class ReportKeeper;
class ScorePane;
struct LiveMoment;

/// The hand-in (docs/design.md, "The window"): facts about the mission, the estimated score ("score"), and
/// the folder for the judges. The folder is written at once and every minute while the mission runs, also
/// after it was resumed.
class ReportFeature final : public QObject {
    Q_OBJECT
public:
    explicit ReportFeature(const LiveContext& context);
    ~ReportFeature() override;

    [[nodiscard]] QWidget& pane() const;
    /// Returns the time between the starts of two reports.
    [[nodiscard]] std::chrono::nanoseconds interval() const { return m_interval; }
    void setInterval(std::chrono::nanoseconds interval);  ///< also used for the present report

private:
    void addCommands();
    void askForData();
    void askForFolder();
    void keep(const QString& folder);
    void beginKeeping(const QString& folder);
    void endKeeping();
    void stop();
    void goOn();
    void remember(const QString& folder);
    void show(const LiveMoment& moment);

    LiveContext m_context;
    ScoreBoard m_board;
    ScorePane* m_score;
    QAction* m_keep = nullptr;
    QString m_folder;  ///< folder of the report; empty: none is written
    std::chrono::nanoseconds m_interval = std::chrono::seconds(60);
    std::unique_ptr<ReportKeeper> m_keeper;
    std::vector<std::unique_ptr<ReportKeeper>> m_ended;  ///< keepers that may still be writing
    int m_sinceScore = 0;                                ///< number of ticks
};

}  // namespace leitstand
