#include "app/window/panes/compare/compare_feature.h"

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/source/moment_source.h"
#include "app/window/source/review_bridge.h"
#include "app/window/source/review_comparison.h"
#include "widgets/models/map/live_map_text.h"
#include "widgets/models/review/compared_text.h"
#include "widgets/review/compare_panel.h"

namespace leitstand {

CompareFeature::CompareFeature(const ReviewContext& context, MapFeature& map)
    : QObject(&context.window),
      m_context(context),
      m_bridge(context.review),
      m_map(map),
      m_panel(new ComparePanel(&context.window)) {
    m_panel->setObjectName(QStringLiteral("comparePane"));
    QAction& open = context.commands.add(
        {.id = QStringLiteral("review.compare"),
         .menu = CommandMenu::Mission,
         .text = tr("&Compare registrations"),
         .hint = tr("Registers the key scans with other settings and shows both maps and their figures")});
    connect(&open, &QAction::triggered, this, &CompareFeature::wanted);
    connect(m_panel, &ComparePanel::wanted, this, &CompareFeature::begin);
    connect(m_panel, &ComparePanel::cancelled, this, [this] { comparison().cancel(); });
    connect(m_panel, &ComparePanel::mapChosen, this, &CompareFeature::choose);
    connect(&comparison(), &ReviewComparison::progressed, m_panel, &ComparePanel::showProgress);
    connect(&comparison(), &ReviewComparison::changed, this, &CompareFeature::show);
    show();
}

QWidget& CompareFeature::pane() const {
    return *m_panel;
}

ReviewComparison& CompareFeature::comparison() const {
    return m_bridge.comparison();
}

void CompareFeature::begin(const RegistrationSettings& settings) {
    if (m_bridge.index()) return comparison().begin(m_bridge.index(), settings);
    m_panel->setComparing(false);
    m_context.notify(tr("The mission is still read through"));
}

void CompareFeature::show() {
    m_panel->setComparing(comparison().comparing());
    m_panel->showProgress(comparison().progress());
    if (comparison().comparing() || comparison().result()) m_panel->setSettings(comparison().settings());
    if (!comparison().result()) return;
    m_panel->showResult(*comparison().result()->comparison);
    m_panel->choose(comparison().shown());
    showMap();
}

void CompareFeature::choose(ComparedMap which) {
    comparison().show(which);
    showMap();
}

void CompareFeature::showMap() {
    const ComparedMapsPtr maps = comparison().result();
    if (!maps) return;
    const ComparedMap which = comparison().shown();
    if (which == ComparedMap::Recorded) {
        m_bridge.showInstead(nullptr);
        m_map.describe([](const LiveMoment& moment) {
            return liveSummaryOf({.map = *moment.scans,
                                  .robots = *moment.places,
                                  .now = moment.now,
                                  .kind = comparedMapText(ComparedMap::Recorded)});
        });
    } else {
        m_bridge.showInstead(which == ComparedMap::Again ? maps->again : maps->both);
        m_map.describe(
            [summary = comparedSummaryOf(*maps->comparison, which)](const LiveMoment&) { return summary; });
    }
}

}  // namespace leitstand
