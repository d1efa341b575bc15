#include "app/window/review/timeline_feature.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include <QAction>
#include <QKeySequence>
#include <QMainWindow>
#include <QVBoxLayout>

#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/source/review_bridge.h"
#include "widgets/models/timeline/timeline_text.h"
#include "widgets/models/times.h"
#include "widgets/timeline/timeline_bar.h"
#include "widgets/timeline/transport_bar.h"

namespace leitstand {
namespace {

constexpr char VictimLetter = 'V';  ///< first letter of nameOf() of a victim

template <TimelineMark::Kind kind>
bool isOf(const TimelineMark& mark) {
    return mark.kind == kind;
}

bool isVictim(const TimelineMark& mark) {
    return isOf<TimelineMark::Kind::Victim>(mark) && mark.name.starts_with(VictimLetter);
}

bool isOtherFind(const TimelineMark& mark) {
    return isOf<TimelineMark::Kind::Victim>(mark) && !mark.name.starts_with(VictimLetter);
}

}  // namespace

TimelineFeature::TimelineFeature(const ReviewContext& context)
    : QObject(&context.window),
      m_context(context),
      m_bridge(context.review),
      m_whole(new QWidget(&context.window)),
      m_transport(new TransportBar(m_whole)),
      m_bar(new TimelineBar(m_whole)) {
    auto* rows = new QVBoxLayout(m_whole);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_transport);
    rows->addWidget(m_bar);
    addCommands();
    if (m_bridge.player().mapsOffline()) addMapping();
    connect(m_bar, &TimelineBar::sought, this, [this](Time at) { m_bridge.player().seek(at); });
    connect(m_bar, &TimelineBar::stepped, this, [this](double seconds) {
        m_bridge.player().step(std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
    });
    connect(&context.review, &ReviewBridge::opening, this, &TimelineFeature::showOpening);
    connect(&context.review, &ReviewBridge::opened, this, &TimelineFeature::showMission);
    connect(&context.review, &MomentSource::ticked, this, &TimelineFeature::showMoment);
}

QAction& TimelineFeature::add(const char* id, const QString& text, const QString& hint,
                              const QKeySequence& keys, const char* icon, bool checkable) {
    QAction& action = m_context.commands.add({.id = QString::fromLatin1(id),
                                              .menu = CommandMenu::Mission,
                                              .text = text,
                                              .hint = hint,
                                              .keys = keys,
                                              .checkable = checkable,
                                              .icon = icon});
    return action;
}

void TimelineFeature::addCommands() {
    using Kind = TimelineMark::Kind;
    const auto on = [this](QAction& action, auto call) {
        connect(&action, &QAction::triggered, this, call);
        m_transport->addCommand(action);
    };
    on(add("review.previous", tr("&Previous mark"), tr("Back to the mark before"), Qt::Key_P, "previous"),
       [this] { jump(false); });
    m_back = &add("review.backwards", tr("Play &backwards"), tr("Plays backwards, or stands"),
                  Qt::SHIFT | Qt::Key_Space, "play-back", true);
    on(*m_back, [this] { toggle(-1.0); });
    m_play = &add("review.play", tr("&Play"), tr("Plays, or stands"), Qt::Key_Space, "play", true);
    on(*m_play, [this] { toggle(1.0); });
    on(add("review.next", tr("&Next mark"), tr("On to the next mark"), Qt::Key_N, "next"),
       [this] { jump(true); });
    m_transport->addGap();
    on(add("review.slower", tr("&Slower"), tr("Plays slower, down to a tenth"), Qt::Key_BracketLeft,
           "slower"),
       [this] { change(false); });
    on(add("review.faster", tr("&Faster"), tr("Plays faster, up to 32 times"), Qt::Key_BracketRight,
           "faster"),
       [this] { change(true); });
    m_transport->addGap();
    m_context.commands.separate(CommandMenu::Mission);
    on(add("review.nextVictim", tr("Next &victim"),
           tr("On to where the next victim was filed or changed, from the last to the first"), Qt::Key_F3),
       [this] { jumpTo(&isVictim, true); });
    QAction& before =
        add("review.previousVictim", tr("Previous v&ictim"),
            tr("Back to where the victim before was filed or changed, from the first to the last"),
            Qt::SHIFT | Qt::Key_F3);
    connect(&before, &QAction::triggered, this, [this] { jumpTo(&isVictim, false); });
    QAction& hazard =  // in the menu alone: the bar has no room for more where words are long
        add("review.nextHazard", tr("Next &hazard"),
            tr("On to the next hazard sign, QR code or object, from the last to the first"), Qt::Key_H);
    connect(&hazard, &QAction::triggered, this, [this] { jumpTo(&isOtherFind, true); });
    QAction& candidate =
        add("review.nextCandidate", tr("Next &candidate"),
            tr("On to what the station believed next to have found, from the last to the first"), Qt::Key_C);
    connect(&candidate, &QAction::triggered, this, [this] { jumpTo(&isOf<Kind::Candidate>, true); });
    on(add("review.nextAlarm", tr("Next &alarm"), tr("On to the next alarm, from the last to the first"),
           Qt::Key_A),
       [this] { jumpTo(&isOf<Kind::Alarm>, true); });
    on(add("review.nextNote", tr("Next n&ote"), tr("On to the next note, from the last to the first"),
           Qt::Key_O),
       [this] { jumpTo(&isOf<Kind::Note>, true); });
    m_context.commands.separate(CommandMenu::Mission);
    QAction& finished = add("review.finished", tr("&Map as finished"),
                            tr("The map as the mission ended, with all corrections; else as it was then"),
                            Qt::Key_M, nullptr, true);
    finished.setChecked(m_bridge.player().map() == ReviewMap::Finished);
    on(finished,
       [this](bool checked) { m_bridge.player().show(checked ? ReviewMap::Finished : ReviewMap::AsThen); });
}

void TimelineFeature::addMapping() {
    QAction& stop = add("review.stopMapping", tr("Stop &mapping"),
                        tr("No station made a map of this mission, so that its point clouds are registered "
                           "first; stopped, the review has those that are registered by then"),
                        {});
    connect(&stop, &QAction::triggered, this, [this, &stop] {
        m_bridge.player().stopMapping();
        stop.setEnabled(false);
    });
    stop.setEnabled(!m_bridge.index());
    connect(&m_bridge, &ReviewBridge::opened, &stop, [&stop] { stop.setEnabled(false); });
}

void TimelineFeature::showOpening(double fraction) {
    const int percent = static_cast<int>(100.0 * fraction);
    m_bar->setOpening(fraction,
                      fraction < ReviewPlayer::MapPart && m_bridge.player().mapsOffline()
                          ? tr("registers the point clouds, since no station made a map: %1 %").arg(percent)
                          : QString());
}

void TimelineFeature::toggle(double direction) {
    const double now = m_bridge.player().rate();
    const bool goesThere = now != 0.0 && (now > 0.0) == (direction > 0.0);
    m_bridge.player().play(goesThere ? 0.0 : direction * m_speed);
    showMoment();
}

void TimelineFeature::change(bool faster) {
    m_speed = nextRate(m_speed, faster);
    const double now = m_bridge.player().rate();
    if (now != 0.0) m_bridge.player().play(std::copysign(m_speed, now));
    m_context.notify(tr("Plays at %1").arg(rateText(m_speed)));
    showMoment();
}

void TimelineFeature::go(const TimelineMark* mark) {
    if (mark == nullptr) return m_context.notify(tr("There is no such mark"));
    m_bridge.player().seek(mark->at);
    const std::vector<RobotFace> faces = m_context.selection.faces();
    m_context.notify(wallText(mark->at) + QStringLiteral(" · ") + markText(*mark, faces));
}

void TimelineFeature::jump(bool forwards) {
    const Time now = m_bridge.player().position();
    go(forwards ? markAfter(m_marks, now) : markBefore(m_marks, now));
}

void TimelineFeature::jumpTo(bool (*wanted)(const TimelineMark&), bool forwards) {
    std::vector<TimelineMark> of;
    std::copy_if(m_marks.begin(), m_marks.end(), std::back_inserter(of), wanted);
    const Time now = m_bridge.player().position();
    const TimelineMark* const next = forwards ? markAfter(of, now) : markBefore(of, now);
    go(next != nullptr || of.empty() ? next : forwards ? &of.front() : &of.back());
}

void TimelineFeature::setOwnMarks(std::vector<TimelineMark> marks) {
    m_own = std::move(marks);
    showMission();
}

void TimelineFeature::showMission() {
    if (!m_bridge.index()) return;
    m_axis = TimelineAxis(m_bridge.index()->stretches);
    m_marks = m_bridge.index()->marks;
    // Drops notes of earlier reviews that were taken back in this one.
    if (const MissionStatePtr written = m_bridge.pen().state()) dropUndone(m_marks, *written);
    m_marks.insert(m_marks.end(), m_own.begin(), m_own.end());
    std::stable_sort(m_marks.begin(), m_marks.end(),
                     [](const TimelineMark& a, const TimelineMark& b) { return a.at < b.at; });
    const std::vector<RobotFace> faces = m_context.selection.faces();
    m_bar->setMission(m_axis, glyphsOf(m_marks, m_axis, faces));
    showMoment();
}

void TimelineFeature::showMoment() {
    const double rate = m_bridge.player().rate();
    m_play->setChecked(rate > 0.0);
    m_back->setChecked(rate < 0.0);
    const Time at = m_bridge.reviewed() ? m_bridge.reviewed()->now : m_bridge.player().position();
    m_bar->setPosition(at);
    m_transport->show(m_axis, at, rate);
}

}  // namespace leitstand
