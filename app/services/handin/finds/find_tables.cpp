#include "app/services/handin/finds/find_tables.h"

#include <optional>
#include <string>

#include "app/services/handin/report_text.h"
#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
namespace {

std::string typeOf(FindSample::Kind kind) {
    switch (kind) {
        case FindSample::Kind::Hazard:
            return "hazmat";
        case FindSample::Kind::Code:
            return "qr";
        case FindSample::Kind::Object:
            return "object";
        case FindSample::Kind::Victim:
            break;
    }
    return "victim";
}

bool belongs(FindSample::Kind kind, FindList::Kind list) {
    switch (list) {
        case FindList::Kind::Victims:
            return kind == FindSample::Kind::Victim;
        case FindList::Kind::Codes:
            return kind == FindSample::Kind::Code;
        case FindList::Kind::Pois:
            break;
    }
    return true;
}

/// Returns what stands on it, else what was noted, else its name.
std::string contentOf(const ReportFind& find) {
    if (find.sample.kind == FindSample::Kind::Victim) return find.name;
    if (!find.sample.tag.empty()) return find.sample.tag;
    return find.sample.text.empty() ? find.name : find.sample.text;
}

}  // namespace

FindList listOf(const ReportModel& model, FindList::Kind kind) {
    const bool known = model.facts.begin > Time{};
    FindList list{.kind = kind,
                  .team = model.facts.team,
                  .country = model.facts.country,
                  .date = known ? dateText(model.facts.begin) : std::string(),
                  .time = known ? clockText(model.facts.begin) : std::string(),
                  .mission = model.facts.mission,
                  .finds = {}};
    for (const ReportFind& find : model.finds) {
        const FindSample& sample = find.sample;
        const bool counts = sample.status == FindSample::Status::Confirmed && find.position.allFinite();
        if (!counts || !belongs(sample.kind, kind)) continue;
        // Numbers run per kind; a list of all kinds needs its own numbers.
        const auto id =
            kind == FindList::Kind::Pois ? static_cast<std::uint32_t>(list.finds.size() + 1) : sample.number;
        list.finds.push_back({.id = id,
                              .time = clockText(sample.found),
                              .text = contentOf(find),
                              .position = find.position,
                              .robot = sample.robot,
                              .mode = sample.autonomous ? "A" : "T",
                              .type = typeOf(sample.kind)});
    }
    return list;
}

std::vector<ListedSearch> searchListOf(const ReportModel& model) {
    std::vector<ListedSearch> rows;
    const auto addRow = [&rows](const ReportSearch& search, const ReportSearch::Sensor& one,
                                std::optional<int> storey) {
        const std::string sensor(nameOf(one.sensor));
        rows.push_back({.sensor = sensor,
                        .what = "reachable",
                        .area = search.reachable,
                        .share = search.reachable > 0.0 ? 1.0 : 0.0,
                        .storey = storey});
        rows.push_back({.sensor = sensor,
                        .what = "seen",
                        .area = one.seen,
                        .share = search.reachable > 0.0 ? one.seen / search.reachable : 0.0,
                        .storey = storey});
    };
    for (const ReportSearch::Sensor& one : model.search.sensors) {
        addRow(model.search, one, {});
        for (const ReportStorey& storey : model.storeys) {
            for (const ReportSearch::Sensor& here : storey.search.sensors) {
                if (here.sensor == one.sensor) addRow(storey.search, here, storey.share.number);
            }
        }
        for (const MissedRegion& region : one.missed) {
            rows.push_back({.sensor = std::string(nameOf(one.sensor)),
                            .what = "missed",
                            .area = region.area,
                            .share = region.area / model.search.reachable,
                            .x = region.place.x(),
                            .y = region.place.y(),
                            .storey = model.storeys.empty() ? std::nullopt : std::optional(region.storey)});
        }
    }
    return rows;
}

}  // namespace leitstand
