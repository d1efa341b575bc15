#include "widgets/models/score/score_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/mission/state/find_state.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"
#include "widgets/models/victims/victim_choices.h"

namespace leitstand {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ScoreText)
};

constexpr std::size_t MostAdvice = 5;

QString points(double value) {
    return figureText(value, 1);
}

QString itemText(ScoreItem item) {
    switch (item) {
        case ScoreItem::Map:
            return Texts::tr("map");
        case ScoreItem::Location:
            return Texts::tr("place");
        case ScoreItem::Form:
            return Texts::tr("form");
        case ScoreItem::Motion:
            return Texts::tr("motion");
        case ScoreItem::Heat:
            return Texts::tr("heat");
        case ScoreItem::Sound:
            return Texts::tr("sound");
        case ScoreItem::Co2:
            return Texts::tr("CO₂");
        case ScoreItem::Situation:
            return Texts::tr("situation");
        case ScoreItem::Tag:
            return Texts::tr("tag");
    }
    return {};
}

/// Returns the points of each item out of those possible. Lines do not break within an item.
QString itemsText(const std::vector<ScoredItem>& items) {
    QStringList texts;
    for (const ScoredItem& one : items) {
        if (one.possible <= 0.0) continue;
        texts += QStringLiteral("%1\u00a0%2/%3")
                     .arg(itemText(one.item), figureText(one.points, 2), figureText(one.possible, 2));
    }
    return texts.join(QStringLiteral(", "));
}

QString areaText(const std::string& area) {
    for (const VictimChoice& one : areaChoices()) {
        if (one.word == area) return one.text;
    }
    return othersText(area);
}

ScoreLine lineOf(const ScoredFind& find) {
    QString what = othersText(find.name);
    if (!find.confirmed) return {Texts::tr("%1, not confirmed").arg(what), QStringLiteral("0"), Tone::Muted};
    if (find.weight != 1.0) what += Texts::tr(" · area × %1").arg(numberText(find.weight, 2));
    if (find.factor != 1.0) what += Texts::tr(" · autonomy × %1").arg(numberText(find.factor, 1));
    return {what, points(find.total), Tone::Normal, itemsText(find.items)};
}

}  // namespace

ScoreText scoreText(const ScoreProfile& profile, const ScoreResult& result, const MissionClock& clock) {
    ScoreText text;
    text.score = Texts::tr("%1 points").arg(points(result.score));
    text.rules = Texts::tr("%1 · version %2").arg(othersText(profile.title), othersText(profile.version));
    if (!profile.unconfirmed.empty())
        text.rules += Texts::tr(" · %1 values unconfirmed").arg(profile.unconfirmed.size());
    if (clock.left) {
        const auto minutes = std::chrono::duration_cast<std::chrono::seconds>(*clock.left).count() / 60;
        text.left = minutes >= 0 ? Texts::tr("%1 min left").arg(minutes) : Texts::tr("time is over");
    }
    for (const ScoredFind& find : result.finds) text.finds.push_back(lineOf(find));
    for (const std::string& area : result.unweighed) {
        text.finds.push_back({Texts::tr("area “%1” has no weight in these rules").arg(areaText(area)),
                              QStringLiteral("× 1"), Tone::Muted});
    }
    const auto bumps = [&](std::uint64_t count, double each, const QString& what) {
        if (count > 0 && each > 0.0)
            text.finds.push_back(
                {what.arg(count), points(-each * static_cast<double>(count)), Tone::Attention});
    };
    bumps(result.areaBumps, profile.areaBump, Texts::tr("%1 × touched the arena"));
    bumps(result.victimBumps, profile.victimBump, Texts::tr("%1 × touched a victim"));
    if (result.divisor != 1.0) {
        text.finds.push_back({Texts::tr("operators: %1").arg(result.operators),
                              QStringLiteral("÷ ") + points(result.divisor), Tone::Muted});
    }
    for (const ScoreAdvice& one : result.advice) {
        if (text.advice.size() == MostAdvice) break;
        const QString name = othersText(one.name);
        text.advice.push_back({one.item ? Texts::tr("%1: %2", "V1: heat").arg(name, itemText(*one.item))
                                        : Texts::tr("%1: confirm").arg(name),
                               QLatin1Char('+') + points(one.gain), Tone::Normal});
    }
    return text;
}

}  // namespace leitstand
