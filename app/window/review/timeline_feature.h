#pragma once

#include <vector>

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/mission/timeline/timeline_marks.h"
#include "widgets/models/timeline/timeline_axis.h"

class QAction;
class QKeySequence;
class QWidget;

namespace leitstand {

class ReviewBridge;
class TimelineBar;
class TransportBar;
struct LiveMoment;

/// The mission's time: the timeline along the bottom of the window, and the commands for moving through it.
class TimelineFeature final : public QObject {
    Q_OBJECT
public:
    TimelineFeature(const ReviewContext& context);

    [[nodiscard]] QWidget* widget() const { return m_whole; }
    [[nodiscard]] TimelineBar& bar() const { return *m_bar; }
    /// Sets the marks made in the review, which are shown in addition to those of the mission.
    void setOwnMarks(std::vector<TimelineMark> marks);
    [[nodiscard]] const std::vector<TimelineMark>& marks() const { return m_marks; }

private:
    void addCommands();
    void addMapping();  ///< adds the command that ends mapping
    void showOpening(double fraction);
    QAction& add(const char* id, const QString& text, const QString& hint, const QKeySequence& keys,
                 const char* icon = nullptr, bool checkable = false);
    void toggle(double direction);
    void change(bool faster);
    void jump(bool forwards);
    /// Jumps to the next mark for which @p wanted is true, or if @p forwards is false, to the previous one.
    /// If there is none, continues at the other end.
    void jumpTo(bool (*wanted)(const TimelineMark&), bool forwards);
    void go(const TimelineMark* mark);
    void showMission();
    void showMoment();

    ViewContext m_context;
    ReviewBridge& m_bridge;
    QWidget* m_whole;
    TransportBar* m_transport;
    TimelineBar* m_bar;
    QAction *m_play = nullptr, *m_back = nullptr;
    TimelineAxis m_axis;
    /// Marks by rising time: m_own has those made in the review, m_marks has all.
    std::vector<TimelineMark> m_own, m_marks;
    double m_speed = 1.0;  ///< how many times as fast as real time it plays
};

}  // namespace leitstand
