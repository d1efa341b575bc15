#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/base/result.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_moves.h"
#include "core/mission/state/mission_state.h"
#include "widgets/map_view/gestures/ground_pose.h"

class QAction;
class QKeySequence;

namespace leitstand {

class CameraFeature;
class FindDesk;
class FormPictures;
class MapFeature;
class VictimForm;
class VictimsPanel;
struct LiveMoment;

/// The operator's finds (docs/design.md, "The window"): one key freezes the evidence of a find, another one
/// confirms the find. List and form can wait until later. Everything is in the mission's log.
class VictimsFeature final : public QObject {
    Q_OBJECT
public:
    VictimsFeature(const LiveContext& context, MapFeature& map, CameraFeature& cameras);

    [[nodiscard]] QWidget& list() const;
    [[nodiscard]] QWidget& form() const;

private:
    QAction& add(const char* id, const QString& text, const QString& brief, const QString& hint,
                 const QKeySequence& keys);
    void addFreezing();
    void addDecisions();
    void addForm();
    void addPlacing();
    void freeze(FindSample::Kind kind);
    void confirm();
    void merge();
    void move(bool on);
    void answer(const Result<void>& done);  ///< shows an error
    /// Returns the find to which a command applies: the selected one; if none is, the one filed last if it is
    /// not confirmed yet. Empty: there is none, or a candidate is selected.
    [[nodiscard]] std::optional<FindKey> meant() const;
    void show(const LiveMoment& moment);
    void showForm();
    void fillIn(int step);  ///< opens the form of the selected find at its next or previous field
    void changeField();
    [[nodiscard]] bool isFillingIn() const;
    [[nodiscard]] FindDesk& desk() const;

    LiveContext m_context;
    MapFeature& m_map;
    CameraFeature& m_cameras;
    VictimsPanel* m_panel;
    VictimForm* m_form;
    FormPictures* m_pictures;
    std::map<QString, QAction*> m_actions;
    std::uint64_t m_shown = 0;  ///< FindDesk::filings() when its newest find was selected in the list
    std::uint32_t m_asked = 0;  ///< candidate whose filing was requested last; 0: none
    int m_sinceRows = 0;        ///< number of ticks
    FindMoves m_moves;
    bool m_following = false;  ///< whether m_moves has taken the moves of earlier sessions
};

}  // namespace leitstand
