#include "app/report/score_html.h"

#include <QCoreApplication>
#include <QStringList>

#include "app/report/report_numbers.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
namespace {

/// Text of the score's page, for translators.
struct ScoreText {
    Q_DECLARE_TR_FUNCTIONS(ScoreText)
};

QString safe(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped();
}
QString number(double value) {
    return reportNumber(value, 2);
}

QString autonomyOf(Autonomy autonomy) {
    switch (autonomy) {
        case Autonomy::Teleoperated:
            return ScoreText::tr("teleoperated");
        case Autonomy::Semi:
            return ScoreText::tr("robot drove, station or operator found");
        case Autonomy::Full:
            return ScoreText::tr("robot drove and found by itself");
    }
    return {};
}

/// Returns the name of @p item as in the window's estimate, with the window's translations.
QString itemText(ScoreItem item) {
    const auto text = [](const char* words) {
        return QCoreApplication::translate("leitstand::ScoreText", words);
    };
    switch (item) {
        case ScoreItem::Location:
            return text("place");
        case ScoreItem::Co2:
            return text("CO₂");
        case ScoreItem::Map:
        case ScoreItem::Form:
        case ScoreItem::Motion:
        case ScoreItem::Heat:
        case ScoreItem::Sound:
        case ScoreItem::Situation:
        case ScoreItem::Tag:
            break;
    }
    return text(toString(item));
}

/// Returns @p key of a profile's file in words; an unknown key as it is.
QString keyText(const std::string& key) {
    if (key == "areas") return ScoreText::tr("weights of the areas");
    if (key == "points") return ScoreText::tr("points of the items");
    if (key == "area_bump") return ScoreText::tr("penalty of a contact with the arena");
    if (key == "victim_bump") return ScoreText::tr("penalty of a contact with a victim");
    if (key == "operators") return ScoreText::tr("divisor by operators");
    if (key == "hazard") return ScoreText::tr("points of a hazard sign");
    if (key == "code") return ScoreText::tr("points of a QR code");
    if (key == "object") return ScoreText::tr("points of an object of interest");
    if (key == "autonomous") return ScoreText::tr("factor of autonomy");
    if (key == "semi_autonomous") return ScoreText::tr("factor of semi-autonomy");
    if (key == "minutes") return ScoreText::tr("minutes of a mission");
    return safe(key);
}

QString itemsOf(const ScoredFind& find) {
    QStringList items;
    for (const ScoredItem& item : find.items) {
        if (item.possible > 0.0)
            items += QStringLiteral("%1 %2/%3")
                         .arg(itemText(item.item), number(item.points), number(item.possible));
    }
    return items.isEmpty() ? QStringLiteral("\u2013") : items.join(QStringLiteral(", "));
}

QString row(const QStringList& cells, const char* tag) {
    QString html = QStringLiteral("<tr>");
    for (const QString& cell : cells)
        html += QStringLiteral("<%1 align='left'>%2</%1>").arg(QString::fromUtf8(tag), cell);
    return html + QStringLiteral("</tr>");
}

QString storeyOf(const ReportModel& model, const ScoredFind& scored) {
    for (const ReportFind& find : model.finds) {
        if (find.name == scored.name && find.storey) return QString::fromStdString(storeyName(*find.storey));
    }
    return QStringLiteral("\u2013");
}

/// Returns the points of the confirmed finds on each storey. Empty when there is only one storey.
QString storeySums(const ReportContent& content) {
    QStringList sums;
    for (const ReportStorey& storey : content.model.storeys) {
        const QString name = QString::fromStdString(storeyName(storey.share.number));
        double sum = 0.0;
        for (const ScoredFind& find : content.score.finds) {
            if (find.confirmed && storeyOf(content.model, find) == name) sum += find.total;
        }
        sums += ScoreText::tr("storey %1: %2").arg(name, number(sum));
    }
    if (sums.isEmpty()) return {};
    return QStringLiteral("<p>%1</p>")
        .arg(ScoreText::tr("Of the finds, by storey: %1.").arg(sums.join(QStringLiteral(", "))));
}

}  // namespace

QString scoreHtml(const ReportContent& content) {
    if (!content.profile) return {};
    const ScoreProfile& profile = *content.profile;
    const ScoreResult& result = content.score;
    QString html = QStringLiteral("<h2>%1</h2>").arg(ScoreText::tr("Score, estimated"));
    html += QStringLiteral("<p>%1</p>")
                .arg(ScoreText::tr("Profile %1 (%2), version %3. The quality of the map is the judges' to "
                                   "tell; here it counts as full.")
                         .arg(safe(profile.name), safe(profile.title), safe(profile.version)));
    html += QStringLiteral(
        "<table border='1' cellspacing='0' cellpadding='4' width='100%' "
        "style='border-collapse:collapse; border-color:#999999'>");
    const bool several = !content.model.storeys.empty();
    QStringList heads = {QString(),
                         ScoreText::tr("Items"),
                         ScoreText::tr("Points"),
                         ScoreText::tr("Area"),
                         ScoreText::tr("Autonomy"),
                         ScoreText::tr("Total")};
    if (several) heads.insert(1, ScoreText::tr("Storey"));
    html += row(heads, "th");
    for (const ScoredFind& find : result.finds) {
        QStringList cells = {QStringLiteral("<b>%1</b>").arg(safe(find.name)),
                             itemsOf(find),
                             number(find.points),
                             QStringLiteral("x %1").arg(number(find.weight)),
                             QStringLiteral("%1, x %2").arg(autonomyOf(find.autonomy), number(find.factor)),
                             find.confirmed ? number(find.total)
                                            : ScoreText::tr("%1 (not confirmed)").arg(number(find.total))};
        if (several) cells.insert(1, storeyOf(content.model, find));
        html += row(cells, "td");
    }
    html += QStringLiteral("</table>") + storeySums(content);
    html +=
        QStringLiteral("<p>%1</p>")
            .arg(ScoreText::tr("%1 of the finds, less %2 for contacts (%3 with the arena, %4 with victims), "
                               "divided by %5 (operators: %6): <b>%7</b>")
                     .arg(number(result.sum), number(result.penalty))
                     .arg(result.areaBumps)
                     .arg(result.victimBumps)
                     .arg(number(result.divisor))
                     .arg(result.operators)
                     .arg(number(result.score)));
    for (const std::string& area : result.unweighed) {
        html += QStringLiteral("<p>%1</p>")
                    .arg(ScoreText::tr(
                             "The profile has no weight for the area \u201c%1\u201d: its finds count once.")
                             .arg(safe(area)));
    }
    if (!profile.unconfirmed.empty()) {
        QStringList keys;
        for (const std::string& key : profile.unconfirmed) keys += keyText(key);
        html += QStringLiteral("<p>%1</p>")
                    .arg(ScoreText::tr("Values of the profile for which no readable source was found: %1.")
                             .arg(keys.join(QStringLiteral(", "))));
    }
    return html;
}

}  // namespace leitstand
