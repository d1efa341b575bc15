#include "widgets/models/review/find_rows.h"

#include <QCoreApplication>
#include <QStringList>

#include "widgets/models/numbers.h"
#include "widgets/models/timeline/timeline_words.h"

namespace leitstand {
namespace {

struct FindTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::FindRow)
};

QString detailsOf(const VictimSample& find) {
    QStringList parts;
    if (!find.tag.empty()) parts += FindTexts::tr("“%1”").arg(QString::fromStdString(find.tag));
    if (!find.situation.empty()) parts += situationText(find.situation);
    if (!find.text.empty()) parts += QString::fromStdString(find.text);
    return parts.join(QStringLiteral(" · "));
}

}  // namespace

QString statusText(const VictimSample& find) {
    switch (find.status) {
        case VictimSample::Status::Hypothesis:
            return FindTexts::tr("hypothesis");
        case VictimSample::Status::Confirmed:
            return FindTexts::tr("confirmed");
        case VictimSample::Status::Discarded:
            break;
    }
    if (find.mergedInto != 0)
        return FindTexts::tr("part of %1").arg(QString::fromStdString(nameOf(find.kind, find.mergedInto)));
    return FindTexts::tr("discarded");
}

QString situationText(const std::string& situation) {
    if (situation.empty()) return FindTexts::tr("unknown");
    if (situation == "surface") return FindTexts::tr("surface");
    if (situation == "trapped") return FindTexts::tr("trapped");
    if (situation == "void") return FindTexts::tr("void");
    if (situation == "entombed") return FindTexts::tr("entombed");
    return QString::fromStdString(situation);
}

QString areaText(const std::string& area) {
    if (area.empty()) return FindTexts::tr("unknown");
    if (area == "yellow") return FindTexts::tr("yellow");
    if (area == "orange") return FindTexts::tr("orange");
    if (area == "red") return FindTexts::tr("red");
    return QString::fromStdString(area);
}

std::vector<FindRow> findRowsOf(const MissionState& state) {
    std::vector<FindRow> rows;
    for (const auto& [key, kept] : *state.victims) {
        const VictimSample& find = kept.victim;
        FindRow row;
        row.key = key;
        row.found = find.found;
        row.name = QString::fromStdString(nameOf(find.kind, find.number));
        row.status = statusText(find);
        row.since = wallText(find.found);
        row.place = positionText(positionInMap(state, find));
        row.details = detailsOf(find);
        if (find.status == VictimSample::Status::Discarded) row.tone = Tone::Muted;
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace leitstand
