#pragma once

#include <functional>
#include <optional>

#include <QObject>

#include "app/session/review/review_pen.h"
#include "app/window/live/live_context.h"
#include "core/base/result.h"

namespace leitstand {

class FindsPanel;
class ReviewBridge;
class VictimForm;

/// What was found ("finds"), as then or as the mission has it now: corrections and notes of the review.
class FindsFeature final : public QObject {
    Q_OBJECT
public:
    FindsFeature(const ViewContext& context, ReviewBridge& bridge);
    ~FindsFeature() override;

    [[nodiscard]] const MissionState& state() const;  ///< whose finds are shown
    [[nodiscard]] std::optional<FindKey> chosen() const;

public slots:
    void askForNote();  ///< about the moment that is shown; the review goes on meanwhile

signals:
    void told(const QString& text);
    void marksChanged(const std::vector<leitstand::TimelineMark>& marks);  ///< of what the pen wrote

private:
    void addCommands();
    void show();
    void judge(const FindKey& find, VictimSample::Status status);
    void openForm(const FindKey& find);
    void correct(const VictimSample& corrected);  ///< as the form has it
    void note(Time at, const QString& text);
    /// Off this thread: the first entry opens the mission. @p done: what is told then.
    void write(std::function<Result<void>(ReviewPen&)> what, const QString& done);
    void undo();
    [[nodiscard]] const VictimSample* newest(const FindKey& find) const;

    ViewContext m_context;
    ReviewBridge& m_bridge;
    FindsPanel* m_panel;
    VictimForm* m_form;
};

}  // namespace leitstand
