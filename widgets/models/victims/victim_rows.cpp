#include "widgets/models/victims/victim_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QCoreApplication>
#include <QStringList>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/find_state.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"
#include "widgets/models/times.h"
#include "widgets/models/victims/move_text.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;
using Status = FindSample::Status;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::VictimRows)
};

struct FindTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::FindRow)
};

void addSign(QStringList& to, const QString& name, const VictimSign& sign, const QString& unit,
             int decimals) {
    if (sign.state == VictimSign::State::Unknown) return;
    if (sign.state == VictimSign::State::Absent) {
        to += Texts::tr("no %1", "a sign of life").arg(name);
        return;
    }
    QString text = name;
    if (!std::isnan(sign.value)) text += QLatin1Char(' ') + numberText(sign.value, decimals) + unit;
    if (!sign.text.empty()) text += QLatin1Char(' ') + othersText(sign.text);
    to += text;
}

QString cueText(const Cue& cue) {
    if (cue.kind == "heat") {
        return std::isnan(cue.value) ? Texts::tr("heat")
                                     : Texts::tr("heat %1 °C").arg(numberText(cue.value, 0));
    }
    if (cue.kind == "motion") return Texts::tr("motion");
    if (cue.kind == "co2") {
        return std::isnan(cue.value) ? Texts::tr("CO₂")
                                     : Texts::tr("CO₂ %1 ppm").arg(numberText(cue.value, 0));
    }
    if (cue.kind == "sighting") return Texts::tr("the robot's own");
    if (cue.kind == "tag") return Texts::tr("tag %1").arg(othersText(cue.text));
    return cue.text.empty() ? kindText(cue.kind == "code" ? Kind::Code : Kind::Hazard) : othersText(cue.text);
}

VictimRow rowOf(const MissionState& mission, const FindKey& key, const FindState& entry,
                const std::optional<Pose>& robotInMap, const FindMoves* moves) {
    const FindSample whole = wholeFind(mission, key).value_or(entry.victim);
    VictimRow row;
    row.find = key;
    row.name = QString::fromStdString(nameOf(key.first, key.second));
    row.what = kindText(key.first);
    row.confirmed = whole.status == Status::Confirmed;
    row.discarded = whole.status == Status::Discarded;
    row.state = statusText(whole);
    row.tone = row.confirmed ? Tone::Normal : row.discarded ? Tone::Muted : Tone::Attention;
    row.found = whole.found;
    row.since = wallText(whole.found);
    row.inMap = positionInMap(mission, entry.victim);
    row.deviation = whole.deviation;
    row.place = positionText(row.inMap);
    if (const FindMove* move = moves == nullptr ? nullptr : moves->newest(key)) row.moved = movedText(*move);
    if (robotInMap) row.where = whereText(*robotInMap, row.inMap);
    row.signs = signsText(whole);
    return row;
}

VictimRow rowOf(const MissionState& mission, const CandidateSample& candidate,
                const std::optional<Pose>& robotInMap) {
    VictimRow row;
    row.find = {candidate.kind, 0};
    row.candidate = candidate.id;
    // In a narrow list, only the letter distinguishes a code from a body.
    row.name = QString::fromStdString(nameOf(candidate.kind, 0)).replace(u'0', u'?');
    row.what = kindText(candidate.kind);
    row.state = Texts::tr("candidate %1").arg(percentText(candidate.confidence));
    row.tone = Tone::Muted;
    row.inMap = positionInMap(mission, candidate);
    row.deviation = candidate.deviation;
    row.found = candidate.stamp;
    row.since = wallText(candidate.stamp);
    if (robotInMap) row.where = whereText(*robotInMap, row.inMap);
    QStringList signs;
    for (const Cue& cue : candidate.cues) {
        const QString text = cueText(cue);
        if (!signs.contains(text)) signs += text;
    }
    row.signs = signs.join(QStringLiteral(" · "));
    return row;
}

}  // namespace

QString kindText(Kind kind) {
    switch (kind) {
        case Kind::Victim:
            return Texts::tr("victim");
        case Kind::Hazard:
            return Texts::tr("hazard");
        case Kind::Code:
            return Texts::tr("QR code");
        case Kind::Object:
            return Texts::tr("object");
    }
    return {};
}

QString whereText(const Pose& robotInMap, const Eigen::Vector3d& place) {
    const Eigen::Vector3d seen = robotInMap.inverse() * place;
    const double distance = seen.head<2>().norm();
    const QString metres = Texts::tr("%1 m").arg(numberText(distance, distance < 10.0 ? 1 : 0));
    const double bearing = std::atan2(seen.y(), seen.x()) * 180.0 / std::numbers::pi;
    const int degrees = 5 * static_cast<int>(std::lround(std::abs(bearing) / 5.0));
    if (distance < 0.3) return metres;
    if (degrees < 10) return Texts::tr("%1, ahead").arg(metres);
    if (degrees > 170) return Texts::tr("%1, behind").arg(metres);
    return (bearing > 0.0 ? Texts::tr("%1, %2° left") : Texts::tr("%1, %2° right")).arg(metres).arg(degrees);
}

QString signsText(const FindSample& find) {
    QStringList signs;
    if (find.kind == Kind::Victim) {
        addSign(signs, Texts::tr("form"), find.form, {}, 0);
        addSign(signs, Texts::tr("motion"), find.motion, {}, 0);
        addSign(signs, Texts::tr("heat"), find.heat, Texts::tr(" °C"), 0);
        addSign(signs, Texts::tr("sound"), find.sound, {}, 0);
        addSign(signs, Texts::tr("CO₂"), find.co2, Texts::tr(" ppm"), 0);
        if (!find.situation.empty()) signs += situationText(find.situation);
    }
    if (!find.tag.empty()) signs += othersText(find.tag);
    if (!find.text.empty()) signs += othersText(find.text);
    return signs.join(QStringLiteral(" · "));
}

std::vector<VictimRow> victimRows(const MissionState& mission, const std::optional<Pose>& robotInMap,
                                  const FindMoves* moves) {
    std::vector<VictimRow> rows;
    for (const auto& [key, entry] : *mission.finds) {
        if (entry.victim.status != Status::Discarded)
            rows.push_back(rowOf(mission, key, entry, robotInMap, moves));
    }
    const std::vector<VictimRow> candidates = candidateRows(mission, robotInMap);
    rows.insert(rows.end(), candidates.begin(), candidates.end());
    return rows;
}

std::vector<VictimRow> candidateRows(const MissionState& mission, const std::optional<Pose>& robotInMap) {
    std::vector<const CandidateSample*> candidates;
    for (const auto& [id, entry] : *mission.candidates) {
        const CandidateSample& one = entry.candidate;
        if (one.dismissed || !(one.confidence >= LeastShownConfidence)) continue;
        if (!isFiled(mission, one)) candidates.push_back(&one);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto* a, const auto* b) { return a->confidence > b->confidence; });
    std::vector<VictimRow> rows;
    rows.reserve(candidates.size());
    for (const CandidateSample* one : candidates) rows.push_back(rowOf(mission, *one, robotInMap));
    return rows;
}

std::vector<VictimRow> filedRows(const MissionState& mission, const FindMoves* moves) {
    std::vector<VictimRow> rows;
    for (const auto& [key, entry] : *mission.finds)
        rows.push_back(rowOf(mission, key, entry, std::nullopt, moves));
    return rows;
}

QString statusText(const FindSample& find) {
    switch (find.status) {
        case Status::Hypothesis:
            return Texts::tr("unconfirmed");
        case Status::Confirmed:
            return Texts::tr("confirmed");
        case Status::Discarded:
            break;
    }
    if (find.mergedInto == 0) return FindTexts::tr("discarded");
    return FindTexts::tr("part of %1").arg(QString::fromStdString(nameOf(find.kind, find.mergedInto)));
}

QString situationText(const std::string& situation) {
    if (situation == "surface") return FindTexts::tr("surface");
    if (situation == "trapped") return FindTexts::tr("trapped");
    if (situation == "void") return FindTexts::tr("void");
    if (situation == "entombed") return FindTexts::tr("entombed");
    return othersText(situation);
}

QString victimsTitle(const std::vector<VictimRow>& rows) {
    int victims = 0, open = 0, others = 0, candidates = 0, discarded = 0;
    for (const VictimRow& row : rows) {
        if (row.discarded) {
            ++discarded;
        } else if (!row.filed()) {
            ++candidates;
        } else if (row.find.first == Kind::Victim) {
            ++victims;
            open += row.confirmed ? 0 : 1;
        } else {
            ++others;
        }
    }
    QString title = victims == 1 ? Texts::tr("1 victim") : Texts::tr("%1 victims").arg(victims);
    if (open > 0) title += Texts::tr(", %1 not confirmed").arg(open);
    if (others > 0) title += others == 1 ? Texts::tr(" · 1 other") : Texts::tr(" · %1 others").arg(others);
    if (candidates > 0)
        title +=
            candidates == 1 ? Texts::tr(" · 1 candidate") : Texts::tr(" · %1 candidates").arg(candidates);
    if (discarded > 0) title += Texts::tr(" · %1 discarded").arg(discarded);
    return title;
}

}  // namespace leitstand
