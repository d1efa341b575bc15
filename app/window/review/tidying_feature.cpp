#include "app/window/review/tidying_feature.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QAction>

#include "app/services/recorded/review_log.h"
#include "app/services/review/map_tidying.h"
#include "app/window/commands/command_table.h"
#include "app/window/source/review_bridge.h"
#include "app/window/source/review_comparison.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"
#include "widgets/map_decisions/map_question.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/numbers.h"

namespace leitstand {

TidyingFeature::TidyingFeature(const ReviewContext& context, MapView& view, QObject* parent)
    : QObject(parent),
      m_context(context),
      m_bridge(context.review),
      m_view(view),
      m_tidy(
          add("review.tidy", tr("T&idy the map"),
              tr("Matches all scans that overlap, whenever they were taken, and moves them together, which "
                 "takes a while; the review is opened again then. What was recorded stays as it is, and it "
                 "can be taken back"))),
      m_back(add("review.untidy", tr("Take the tidying &back"),
                 tr("Scans are where they were before the map was tidied; the review is opened again then"))),
      m_before(add("review.beforeTidying", tr("Sho&w the map before the tidying"),
                   tr("In violet: where scans lay before the map was tidied"))) {
    m_back->setIconText(tr("Take back"));
    m_before->setIconText(tr("Hide"));
    m_before->setCheckable(true);
    m_notice = new MapQuestion(QStringLiteral("tidyingNotice"), {m_back, m_before}, m_view);
    connect(m_tidy, &QAction::triggered, this, [this] { ask(MapTidying::Tidy); });
    connect(m_back, &QAction::triggered, this, [this] { ask(MapTidying::TakeBack); });
    connect(m_before, &QAction::toggled, this, &TidyingFeature::compare);
    if (QAction* const finished = m_context.commands.find(QStringLiteral("review.finished"))) {
        connect(finished, &QAction::toggled, this, [this](bool on) {
            if (!on) m_before->setChecked(false);  // the map shown now is of before the tidying
        });
    }
    connect(&m_bridge, &ReviewBridge::opened, this, &TidyingFeature::follow);
    if (m_bridge.index()) follow();
}

QAction* TidyingFeature::add(const char* id, const QString& text, const QString& hint) {
    QAction& action = m_context.commands.add(
        {.id = QString::fromLatin1(id), .menu = CommandMenu::Mission, .text = text, .hint = hint});
    action.setEnabled(false);
    return &action;
}

void TidyingFeature::ask(MapTidying what) {
    if (m_bridge.reporting() || m_bridge.comparison().comparing())
        return m_context.notify(
            tr("A report is being written, or scans are being registered again: tidy the map after that"));
    emit wanted(what);
}

void TidyingFeature::follow() {
    // Maps that are made when a review opens are not stored.
    const bool ours = !m_bridge.player().mapsOffline() && !isOfOthers(m_bridge.player().folder());
    const MissionState& finished = *m_bridge.index()->finished;
    const bool tidied = ours && canUntidy(finished);
    m_tidy->setEnabled(ours && !finished.keyScans->empty());
    m_back->setEnabled(tidied);
    m_before->setEnabled(tidied && !posesBeforeTidying(finished).empty());
    m_before->setChecked(false);
}

void TidyingFeature::compare(bool on) {
    if (!on) {
        m_view.setGhosts({});
        return m_notice->ask({});
    }
    // Both are maps of the mission's end.
    if (m_bridge.player().map() != ReviewMap::Finished)
        m_context.commands.trigger(QStringLiteral("review.finished"));
    const MissionState& finished = *m_bridge.index()->finished;
    std::map<std::uint64_t, Pose> before = posesBeforeTidying(finished);
    double largest = 0.0;
    for (const auto& [scan, pose] : before)
        largest = std::max(largest, distanceBetween(pose, finished.keyScans->at(scan).pose.scanInMap));
    m_notice->ask(tr("Violet: the map before it was tidied. Scans moved: %1, by up to %2 m.")
                      .arg(before.size())
                      .arg(numberText(largest, 2)));
    m_view.setGhosts(std::move(before));
}

}  // namespace leitstand
