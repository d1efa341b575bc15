#include "app/report/report_html.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QCoreApplication>
#include <QStringList>

#include "app/report/changes_html.h"
#include "app/report/coverage_html.h"
#include "app/report/evidence_html.h"
#include "app/report/report_numbers.h"
#include "app/report/report_times.h"
#include "app/report/score_html.h"
#include "app/report/work_html.h"
#include "app/services/handin/report_text.h"
#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
namespace {

/// Text of the report, for translators.
struct ReportText {
    Q_DECLARE_TR_FUNCTIONS(ReportText)
};

QString safe(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped();
}
QString orDash(const std::string& text) {
    return text.empty() ? QStringLiteral("\u2013") : safe(text);
}

using Rows = std::vector<std::pair<QString, QString>>;

QString pairs(const Rows& rows) {
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='3' width='100%'>");
    for (const auto& [name, value] : rows) {
        html +=
            QStringLiteral("<tr><td width='30%'><span style='color:#555555'>%1</span></td><td>%2</td></tr>")
                .arg(name, value);
    }
    return html + QStringLiteral("</table>");
}

QString table(const std::vector<QStringList>& rows) {
    QString html = QStringLiteral(
        "<table border='1' cellspacing='0' cellpadding='4' width='100%' style='border-collapse:collapse; "
        "border-color:#999999'>");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        html += QStringLiteral("<tr>");
        for (const QString& cell : rows[i])
            html += (i == 0 ? QStringLiteral("<th align='left'>%1</th>") : QStringLiteral("<td>%1</td>"))
                        .arg(cell);
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

QString heading(const QString& text) {
    return QStringLiteral("<h2>%1</h2>").arg(text);
}

QString statusOf(const FindSample& sample) {
    return sample.status == FindSample::Status::Confirmed ? ReportText::tr("confirmed")
                                                          : ReportText::tr("not confirmed");
}
QString modeOf(const FindSample& sample) {
    return sample.autonomous ? ReportText::tr("A (autonomous)") : ReportText::tr("T (teleoperated)");
}
QString kindOf(FindSample::Kind kind) {
    switch (kind) {
        case FindSample::Kind::Victim:
            return ReportText::tr("Victim");
        case FindSample::Kind::Hazard:
            return ReportText::tr("Hazard");
        case FindSample::Kind::Code:
            return ReportText::tr("QR code");
        case FindSample::Kind::Object:
            return ReportText::tr("Object of interest");
    }
    return {};
}

QString positionOf(const ReportFind& find) {
    return ReportText::tr("x %1, y %2, z %3 m")
        .arg(reportNumber(find.position.x(), 2), reportNumber(find.position.y(), 2),
             reportNumber(find.position.z(), 2));
}

/// Returns @p word of the log with the window's translation; an unknown word as it is.
QString situationOf(const std::string& word) {
    if (word.empty()) return orDash(word);
    return QCoreApplication::translate("leitstand::FindRow", word.c_str()).toHtmlEscaped();
}
QString areaOf(const std::string& word) {
    if (word.empty()) return orDash(word);
    return QCoreApplication::translate("leitstand::VictimChoices", word.c_str()).toHtmlEscaped();
}

QString signOf(const VictimSign& sign, const char* unit, int digits) {
    QString text;
    switch (sign.state) {
        case VictimSign::State::Unknown:
            text = ReportText::tr("not known");
            break;
        case VictimSign::State::Absent:
            text = ReportText::tr("none");
            break;
        case VictimSign::State::Present:
            text = ReportText::tr("yes");
            break;
    }
    if (std::isfinite(sign.value))
        text += QStringLiteral(", %1 %2").arg(reportNumber(sign.value, digits), QString::fromUtf8(unit));
    if (!sign.text.empty()) text += QStringLiteral(", ") + safe(sign.text);
    return text;
}

/// Returns the explored area of each storey, to append to the total. Empty when there is only one storey.
QString storeysText(const ReportModel& model) {
    QString text;
    for (const ReportStorey& storey : model.storeys) {
        text += ReportText::tr("; storey %1: %2 m\u00B2")
                    .arg(QString::fromStdString(storeyName(storey.share.number)),
                         reportNumber(storey.explored, 1));
    }
    return text;
}

QString storeyOf(const ReportFind& find) {
    return find.storey ? QString::fromStdString(storeyName(*find.storey)) : QStringLiteral("\u2013");
}

QString missionRows(const ReportContent& content) {
    const ReportFacts& facts = content.model.facts;
    const bool known = facts.events > 0;
    QStringList stations;
    for (const std::string& station : facts.stations) stations += safe(station);
    return pairs(
        {{ReportText::tr("Competition"), orDash(facts.competition)},
         {ReportText::tr("Team"),
          facts.country.empty() ? orDash(facts.team)
                                : QStringLiteral("%1 (%2)").arg(orDash(facts.team), safe(facts.country))},
         {ReportText::tr("Mission"), orDash(facts.mission)},
         {ReportText::tr("Date"),
          known ? QStringLiteral("%1, %2 \u2013 %3")
                      .arg(reportDate(facts.begin), reportClock(facts.begin), reportClock(facts.end))
                : QStringLiteral("\u2013")},
         {ReportText::tr("Duration"),
          facts.clocked ? ReportText::tr("%1 by the mission's clock").arg(safe(spanText(facts.duration)))
                        : safe(spanText(facts.duration))},
         {ReportText::tr("Operators"), QString::number(facts.operators)},
         {ReportText::tr("Area"), areaOf(facts.area)},
         {ReportText::tr("Stations"),
          stations.isEmpty() ? QStringLiteral("\u2013") : stations.join(QStringLiteral(", "))},
         {ReportText::tr("Map"), ReportText::tr("%1 scans, %2 m\u00B2 explored")
                                         .arg(content.model.scans)
                                         .arg(reportNumber(content.model.explored, 1)) +
                                     storeysText(content.model)},
         {ReportText::tr("Report made"),
          QStringLiteral("%1, %2").arg(reportDate(content.created), reportClock(content.created))}});
}

QString robotRows(const ReportModel& model) {
    std::vector<QStringList> rows = {{ReportText::tr("Robot"), ReportText::tr("Way"),
                                      ReportText::tr("Scans in the map"), ReportText::tr("Autonomous"),
                                      ReportText::tr("Teleoperated")}};
    for (const ReportRobot& robot : model.robots) {
        rows.push_back({safe(robot.name),
                        robot.path.poses.empty() ? ReportText::tr("not known")
                                                 : ReportText::tr("%1 m").arg(reportNumber(robot.length, 1)),
                        QString::number(robot.scans), safe(spanText(robot.autonomous)),
                        safe(spanText(robot.teleoperated))});
    }
    return table(rows);
}

QString findRows(const ReportModel& model) {
    if (model.finds.empty()) return QStringLiteral("<p>%1</p>").arg(ReportText::tr("Nothing was filed."));
    constexpr qsizetype Place = 3;  // column of the place; the storey is inserted before it
    std::vector<QStringList> rows = {{QString(), ReportText::tr("What"), ReportText::tr("Status"),
                                      ReportText::tr("Place in the map"), ReportText::tr("Way"),
                                      ReportText::tr("Found"), ReportText::tr("By")}};
    if (!model.storeys.empty()) rows.front().insert(Place, ReportText::tr("Storey"));
    for (const ReportFind& find : model.finds) {
        rows.push_back({QStringLiteral("<b>%1</b>").arg(safe(find.name)), kindOf(find.sample.kind),
                        statusOf(find.sample), positionOf(find),
                        find.way.points.empty()
                            ? QStringLiteral("\u2013")
                            : ReportText::tr("%1 m").arg(reportNumber(find.way.length, 1)),
                        reportClock(find.sample.found),
                        QStringLiteral("%1, %2").arg(orDash(find.sample.robot), find.sample.autonomous
                                                                                    ? QStringLiteral("A")
                                                                                    : QStringLiteral("T"))});
        if (!model.storeys.empty()) rows.back().insert(Place, storeyOf(find));
    }
    return table(rows);
}

QString wayText(const ReportFind& find) {
    if (find.way.points.empty()) return ReportText::tr("No robot drove near it: there is no way to tell.");
    const QString text =
        find.way.clear
            ? ReportText::tr("%1 m from the start of %2 along the driven trail, the last %3 m straight on.")
            : ReportText::tr(
                  "%1 m from the start of %2 along the driven trail; for the last %3 m, no free "
                  "straight way is known.");
    return text.arg(reportNumber(find.way.length, 1), safe(find.way.robot),
                    reportNumber(find.way.lastPiece, 1));
}

QString picturesHtml(const std::vector<PrintedPicture>& pictures, std::size_t find) {
    constexpr int Wide = 300;  // [dots]
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='4' width='100%'>");
    for (std::size_t i = 0; i < pictures.size(); i += 2) {
        html += QStringLiteral("<tr>");
        for (std::size_t j = i; j < std::min(i + 2, pictures.size()); ++j) {
            const Picture& picture = *pictures[j].picture;
            // Without a height, Qt takes the file's height on threads other than the GUI thread.
            html += QStringLiteral(
                        "<td width='50%'><img src='%1' width='%2' height='%3'><br><small>%4</small></td>")
                        .arg(evidenceName(find, j))
                        .arg(Wide)
                        .arg(std::lround(Wide * double(picture.height) / std::max(1, picture.width)))
                        .arg(pictures[j].caption.toHtmlEscaped());
        }
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

}  // namespace

QString evidenceName(std::size_t find, std::size_t picture) {
    return QStringLiteral("evidence-%1-%2").arg(find).arg(picture);
}

QStringList overviewHtml(const ReportContent& content) {
    QStringList sections;
    sections += QStringLiteral("<h1>%1</h1><p>%2</p>")
                    .arg(ReportText::tr("Report of a rescue mission"), safe(content.name)) +
                missionRows(content);
    sections += heading(ReportText::tr("Robots")) + robotRows(content.model);
    QString finds = heading(ReportText::tr("Finds")) + findRows(content.model);
    if (content.model.discarded > 0)
        finds += QStringLiteral("<p>%1</p>")
                     .arg(ReportText::tr("%1 others were discarded or merged.").arg(content.model.discarded));
    sections += finds;
    sections += coverageHtml(content);
    sections += changesHtml(content);
    sections += scoreHtml(content);
    sections += heading(ReportText::tr("What was computed where")) + workHtml(content);
    if (!content.warnings.empty()) {
        QString html = heading(ReportText::tr("What is missing or doubtful")) + QStringLiteral("<ul>");
        constexpr std::size_t Most = 20;
        for (std::size_t i = 0; i < std::min(Most, content.warnings.size()); ++i)
            html += QStringLiteral("<li>%1</li>").arg(safe(content.warnings[i]));
        if (content.warnings.size() > Most)
            html += QStringLiteral("<li>%1</li>")
                        .arg(ReportText::tr("and %1 more").arg(content.warnings.size() - Most));
        sections += html + QStringLiteral("</ul>");
    }
    sections.removeAll(QString());
    return sections;
}

QString findHtml(const ReportContent& content, std::size_t index) {
    const ReportFind& find = content.model.finds[index];
    const FindPages& pages = content.finds[index];
    const FindSample& sample = find.sample;
    QString html = QStringLiteral("<h1>%1 \u2013 %2, %3</h1>")
                       .arg(safe(find.name), kindOf(sample.kind), statusOf(sample));
    Rows rows = {
        {ReportText::tr("Place in the map"),
         positionOf(find) + (std::isfinite(sample.deviation)
                                 ? ReportText::tr(", \u00B1 %1 m").arg(reportNumber(sample.deviation, 2))
                                 : QString())},
        {ReportText::tr("Height"),
         ReportText::tr("%1 m above the floor").arg(reportNumber(find.aboveFloor, 2)) +
             (content.model.storeys.empty() || !find.storey
                  ? QString()
                  : ReportText::tr(" of storey %1").arg(storeyOf(find)))},
        {ReportText::tr("Found"), ReportText::tr("%1, %2 after the mission's begin")
                                      .arg(reportClock(sample.found), safe(spanText(find.missionTime)))},
        {ReportText::tr("By"), QStringLiteral("%1, %2").arg(orDash(sample.robot), modeOf(sample))},
        {ReportText::tr("Tag"), orDash(sample.tag)}};
    if (sample.kind == FindSample::Kind::Victim) {
        const Rows signs = {{ReportText::tr("Form"), signOf(sample.form, "", 1)},
                            {ReportText::tr("Motion"), signOf(sample.motion, "", 1)},
                            {ReportText::tr("Heat"), signOf(sample.heat, "\u00B0C", 1)},
                            {ReportText::tr("Sound"), signOf(sample.sound, "", 1)},
                            {ReportText::tr("CO\u2082"), signOf(sample.co2, "ppm", 0)},
                            {ReportText::tr("Situation"), situationOf(sample.situation)}};
        rows.insert(rows.end(), signs.begin(), signs.end());
    }
    rows.emplace_back(ReportText::tr("Area"),
                      areaOf(sample.area.empty() ? content.model.facts.area : sample.area));
    if (!sample.text.empty()) rows.emplace_back(ReportText::tr("Notes"), safe(sample.text));
    QStringList traces;
    for (const QString& line : evidenceLines(pages)) traces += line.toHtmlEscaped();
    if (!traces.isEmpty()) rows.emplace_back(ReportText::tr("Evidence"), traces.join(QStringLiteral("<br>")));
    html += pairs(rows);
    const std::vector<PrintedPicture> pictures = printedPictures(pages);
    if (!pictures.empty()) html += picturesHtml(pictures, index);
    return html;
}

QString wayHtml(const ReportFind& find) {
    return heading(ReportText::tr("The way to %1").arg(safe(find.name))) +
           QStringLiteral("<p>%1</p>").arg(wayText(find));
}

QString mapCaption(const ReportContent& content, const ReportMap& map) {
    const HeightBand& heights = content.model.bands.at(map.band);
    const QString name = QString::fromStdString(content.name), low = reportNumber(heights.low, 2),
                  high = reportNumber(heights.high, 2);
    if (!map.storey) return ReportText::tr("%1: map at %2 to %3 m above the floor").arg(name, low, high);
    return ReportText::tr("%1: storey %2, map at %3 to %4 m above its floor")
        .arg(name, QString::fromStdString(storeyName(*map.storey)), low, high);
}

}  // namespace leitstand
