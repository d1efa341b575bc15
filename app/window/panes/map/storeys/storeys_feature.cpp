#include "app/window/panes/map/storeys/storeys_feature.h"

#include <algorithm>
#include <cmath>

#include <QAction>

#include "app/window/commands/command_table.h"
#include "app/window/map/map_pane.h"
#include "app/window/map/view_state.h"
#include "app/window/panes/map/storeys/storey_row.h"
#include "app/window/source/moment_source.h"

namespace leitstand {
namespace {

constexpr double Noticed = 0.1;  ///< floors that moved less count as unmoved: each change redraws the map [m]

bool sameStoreys(const std::vector<Storey>& a, const std::vector<Storey>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Storey& one, const Storey& other) {
        return one.number == other.number && std::abs(one.floor - other.floor) < Noticed;
    });
}

}  // namespace

StoreysFeature::StoreysFeature(const ViewContext& context, ViewState& state, MapPane& pane, QObject* parent)
    : QObject(parent), m_context(context), m_state(state), m_row(new StoreyRow(&pane)) {
    pane.setStoreys(*m_row);
    const auto add = [this](const QString& id, const QString& text, Qt::Key key, int by) {
        QAction& action = m_context.commands.add({.id = id,
                                                  .menu = CommandMenu::Map,
                                                  .text = text,
                                                  .hint = hint(),
                                                  .keys = QKeySequence(Qt::ALT | key)});
        connect(&action, &QAction::triggered, this, [this, by] { step(by); });
        return &action;
    };
    m_above = add(QStringLiteral("map.storeyAbove"), tr("Store&y above"), Qt::Key_PageUp, 1);
    m_below = add(QStringLiteral("map.storeyBelow"), tr("Storey belo&w"), Qt::Key_PageDown, -1);
    connect(m_row, &StoreyRow::wanted, this, &StoreysFeature::choose);
    connect(&m_state, &ViewState::changed, this, &StoreysFeature::follow);
    connect(&context.source, &MomentSource::mapChanged, this,
            [this](const MapPtr& map) { setMap(map ? *map : Map{}); });
    showChoice();
}

QString StoreysFeature::hint() {
    return tr("What is above and below that storey is not shown");
}

void StoreysFeature::setMap(const Map& map) {
    std::vector<Storey> storeys = storeysOf(map);
    if (sameStoreys(storeys, m_storeys)) return;
    const auto shown = indexOf(m_chosen);
    const double floor = shown ? m_storeys[*shown].floor : 0.0;
    m_storeys = std::move(storeys);
    m_row->setStoreys(m_storeys);
    // Keeps the floor, whatever its number is now: others may have been found between.
    if (shown && !m_storeys.empty()) {
        const auto nearest =
            std::min_element(m_storeys.begin(), m_storeys.end(), [floor](const Storey& a, const Storey& b) {
                return std::abs(a.floor - floor) < std::abs(b.floor - floor);
            });
        choose(nearest->number);
    } else if (shown) {
        choose(std::nullopt);
    }
    showChoice();
}

std::optional<std::size_t> StoreysFeature::indexOf(std::optional<int> number) const {
    const auto found = std::find_if(m_storeys.begin(), m_storeys.end(),
                                    [number](const Storey& one) { return one.number == number; });
    if (!number || found == m_storeys.end() || m_storeys.size() < 2) return std::nullopt;
    return static_cast<std::size_t>(found - m_storeys.begin());
}

void StoreysFeature::choose(std::optional<int> number) {
    const auto index = indexOf(number);
    m_chosen = index ? number : std::nullopt;
    if (index) m_heights = heightsOf(m_storeys, *index);
    m_state.alter([&](MapViewSettings& settings) {
        settings.minHeight = index ? std::optional(m_heights.from) : std::nullopt;
        settings.maxHeight = index ? m_heights.to : std::nullopt;
    });
    showChoice();
}

void StoreysFeature::step(int by) {
    const auto index = indexOf(m_chosen);
    if (!index) return choose(by > 0 ? m_storeys.back().number : m_storeys.front().number);
    const auto to = static_cast<std::ptrdiff_t>(*index) + by;
    choose(to < 0 || to >= static_cast<std::ptrdiff_t>(m_storeys.size())
               ? std::nullopt
               : std::optional(m_storeys[static_cast<std::size_t>(to)].number));
}

void StoreysFeature::follow() {
    const MapViewSettings& settings = m_state.settings();
    // The operator may have chosen other heights.
    if (m_chosen && (settings.minHeight != m_heights.from || settings.maxHeight != m_heights.to))
        m_chosen.reset();
    showChoice();
}

void StoreysFeature::showChoice() {
    const MapViewSettings& settings = m_state.settings();
    m_row->setChosen(m_chosen, !m_chosen && !settings.minHeight && !settings.maxHeight);
    const bool several = m_storeys.size() > 1;
    for (QAction* one : {m_above, m_below}) one->setEnabled(several);
    const QString hint = several ? StoreysFeature::hint() : tr("The map has one storey only");
    for (QAction* one : {m_above, m_below}) m_context.commands.setHint(one->objectName(), hint);
}

}  // namespace leitstand
