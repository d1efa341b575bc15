#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QKeySequence>
#include <QObject>

#include "app/services/review/review_pen.h"
#include "app/window/panes/view_context.h"
#include "core/mission/finds/find_moves.h"

class QAction;

namespace leitstand {

class ReviewBridge;
class FormPictures;
class VictimForm;
class VictimsPanel;

/// Shows what was found ("finds"), as then or as the mission has it now, with corrections and notes of the
/// review.
class FindsFeature final : public QObject {
    Q_OBJECT
public:
    FindsFeature(const ReviewContext& context);
    ~FindsFeature() override;

    [[nodiscard]] QWidget& list() const;
    [[nodiscard]] QWidget& form() const;
    [[nodiscard]] const MissionState& state() const;  ///< mission whose finds are shown
    [[nodiscard]] std::optional<FindKey> chosen() const;
    /// What a command applies to.
    enum class Of : std::uint8_t { Chosen, Mission };
    /// Offers @p action beside the list. One that applies to the chosen find is enabled while one is chosen.
    void offer(QAction& action, Of of);

public slots:
    void askForNote();  ///< about the moment that is shown; does not hold up the review

signals:
    void findsChanged();                                                   ///< the list or the choice changed
    void marksChanged(const std::vector<leitstand::TimelineMark>& marks);  ///< marks of what the pen wrote

private:
    QAction& add(const char* id, const QString& text, const QString& brief, const QString& hint,
                 const QKeySequence& keys = {});
    void addCommands();
    void enable();  ///< enables the commands that apply now
    void show();
    void confirm();
    void discard();
    void judge(const FindKey& find, FindSample::Status status);
    void merge(const FindKey& find);
    [[nodiscard]] const MissionState& finished() const;  ///< the finished mission with what was written
    void openForm(const FindKey& find);
    /// Returns what the form shows of @p find: as it was at the moment that is shown, or the newest once it
    /// is edited. Empty when it is not known.
    [[nodiscard]] std::optional<FindSample> inForm(const std::optional<FindKey>& find) const;
    void showForm(const std::optional<FindSample>& find);
    void correct(const FindSample& corrected);  ///< writes what the form contains
    void note(Time at, const QString& text);
    void notifyWritten(const QString& done, const QString& problem);
    void undo();
    [[nodiscard]] const FindSample* newest(const FindKey& find) const;

    ViewContext m_context;
    ReviewBridge& m_bridge;
    VictimsPanel* m_panel;
    VictimForm* m_form;
    FormPictures* m_pictures;
    std::optional<FindSample> m_shown;  ///< what the form showed before it was edited
    std::optional<FindKey> m_asked,
        m_corrected;  ///< find whose correction is being written; find whose newest state is shown
    FindMoves m_moves;
    std::vector<QAction*> m_ofChosen;  ///< commands about the chosen find
    QAction *m_confirm = nullptr, *m_discard = nullptr, *m_undo = nullptr;
    mutable MissionStatePtr m_written;  ///< mission that state() refers to: a newer one may come at any time
};

}  // namespace leitstand
