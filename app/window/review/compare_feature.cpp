#include "app/window/review/compare_feature.h"

#include <utility>

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/live/pane_docks.h"
#include "app/window/review/review_bridge.h"
#include "widgets/models/review/comparison_rows.h"
#include "widgets/review/compare_panel.h"

namespace leitstand {

CompareFeature::CompareFeature(const ViewContext& context, ReviewBridge& bridge)
    : QObject(&context.window),
      m_context(context),
      m_bridge(bridge),
      m_panel(new ComparePanel(&context.window)) {
    m_panel->setObjectName(QStringLiteral("comparePane"));
    context.panes.add(QStringLiteral("compare"), tr("Compare"), *m_panel);
    QAction& show = context.commands.add(
        {.id = QStringLiteral("review.compare"),
         .menu = CommandMenu::Mission,
         .text = tr("&Compare registrations"),
         .hint = tr("Registers the key scans with other settings and shows both maps and their figures")});
    connect(&show, &QAction::triggered, this, &CompareFeature::wanted);
    MapComparing::Listener listener;
    listener.onProgress = [this, told = 0.0](double fraction) mutable {
        if (fraction >= told && fraction < told + 0.01) return;  // not a call for every point
        told = fraction;
        hop([this, fraction] { m_panel->showProgress(fraction); });
    };
    listener.onFinished = [this](const Result<MapComparisonPtr>& result) {
        hop([this, result] { finish(result); });
    };
    m_comparing = std::make_unique<MapComparing>(std::move(listener));
    connect(m_panel, &ComparePanel::wanted, this, &CompareFeature::begin);
    connect(m_panel, &ComparePanel::cancelled, this, [this] { m_comparing->cancel(); });
    connect(m_panel, &ComparePanel::mapChosen, this, &CompareFeature::showMap);
}

CompareFeature::~CompareFeature() = default;

void CompareFeature::begin(const RegistrationSettings& settings) {
    if (!m_bridge.index()) {
        m_panel->showResult(nullptr);
        return emit told(tr("The mission is still read through"));
    }
    m_comparing->begin(m_bridge.player().folder(), m_bridge.index(), settings);
}

void CompareFeature::finish(const Result<MapComparisonPtr>& result) {
    if (result && *result) m_result = *result;
    m_panel->showResult(result ? *result : nullptr);
    if (!result) return emit told(QString::fromStdString(result.error().text));
    emit told(*result ? comparedText(**result) : tr("Registering again was cancelled"));
}

void CompareFeature::showMap(ComparedMap which) {
    const bool own = which == ComparedMap::Recorded || !m_result;
    m_bridge.showInstead(own ? nullptr : mapOf(*m_result, which));
}

}  // namespace leitstand
