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

/// Shows the finds of a reviewed mission ("finds"): as they were at the moment that is shown, or as the
/// mission has them now. Lets the operator correct them and write notes.
class FindsFeature final : public QObject {
    Q_OBJECT
public:
    FindsFeature(const ReviewContext& context);
    ~FindsFeature() override;

    [[nodiscard]] QWidget& list() const;
    [[nodiscard]] QWidget& form() const;
    [[nodiscard]] const MissionState& state() const;  ///< state of the mission whose finds are shown
    [[nodiscard]] std::optional<FindKey> chosen() const;
    /// What a command applies to.
    enum class Of : std::uint8_t { Chosen, Mission };
    /// Shows @p action beside the list. An action with Of::Chosen is enabled only while a find is selected.
    void offer(QAction& action, Of of);

public slots:
    void askForNote();  ///< asks for a note about the moment that is shown; does not block the review

signals:
    void findsChanged();  ///< the list or the selection changed
    /// Marks for what was written with the pen.
    void marksChanged(const std::vector<leitstand::TimelineMark>& marks);

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
    [[nodiscard]] const MissionState& finished() const;  ///< the finished mission, including what was written
    void openForm(const FindKey& find);
    /// Returns the state of @p find for the form: at the moment that is shown. After the form was opened by
    /// its command or edited, returns the newest state. Empty: it is not known.
    [[nodiscard]] std::optional<FindSample> inForm(const std::optional<FindKey>& find) const;
    void showForm(const std::optional<FindSample>& find);
    void correct(const FindSample& corrected);  ///< writes the content of the form
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
    /// The correction of m_asked is being written; the newest state of m_corrected is shown.
    std::optional<FindKey> m_asked, m_corrected;
    FindMoves m_moves;
    std::vector<QAction*> m_ofChosen;  ///< commands for the selected find
    QAction *m_confirm = nullptr, *m_discard = nullptr, *m_undo = nullptr;
    /// Keeps alive what state() refers to, since a newer mission may arrive at any time.
    mutable MissionStatePtr m_written;
};

}  // namespace leitstand
