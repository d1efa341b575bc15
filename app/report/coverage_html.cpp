#include "app/report/coverage_html.h"

#include <algorithm>

#include <QCoreApplication>

#include "app/report/report_numbers.h"

namespace leitstand {
namespace {

/// Text of the report, for translators.
struct CoverageText {
    Q_DECLARE_TR_FUNCTIONS(CoverageText)
};

constexpr std::size_t MostListed = 5;  ///< missed regions per sensor

QString titleOf(SearchSensor sensor) {
    switch (sensor) {
        case SearchSensor::Camera:
            return CoverageText::tr("Camera");
        case SearchSensor::Infrared:
            return CoverageText::tr("Infrared");
        case SearchSensor::Scanner:
            break;
    }
    return CoverageText::tr("Scanner");
}

QString missedText(const std::vector<MissedRegion>& regions, bool several) {
    if (regions.empty()) return CoverageText::tr("nothing");
    QStringList texts;
    for (std::size_t i = 0; i < std::min(MostListed, regions.size()); ++i) {
        const QString area = reportNumber(regions[i].area, 1), x = reportNumber(regions[i].place.x(), 1),
                      y = reportNumber(regions[i].place.y(), 1);
        texts += several ? CoverageText::tr("%1 m\u00B2 at x %2, y %3, storey %4")
                               .arg(area, x, y, QString::fromStdString(storeyName(regions[i].storey)))
                         : CoverageText::tr("%1 m\u00B2 at x %2, y %3").arg(area, x, y);
    }
    if (regions.size() > MostListed)
        texts += CoverageText::tr("and %1 more").arg(regions.size() - MostListed);
    return texts.join(QStringLiteral("<br>"));
}

QString share(double seen, double reachable) {
    return reachable > 0.0 ? CoverageText::tr("%1 %").arg(reportNumber(100.0 * seen / reachable, 0))
                           : QStringLiteral("\u2013");
}

/// Returns a table of the share of each storey that was seen. Empty when there is only one storey.
QString storeysHtml(const ReportModel& model) {
    if (model.storeys.empty()) return {};
    QString html = QStringLiteral(
                       "<p></p><table border='1' cellspacing='0' cellpadding='4' width='100%' "
                       "style='border-collapse:collapse; border-color:#999999'><tr><th align='left'>%1</th>"
                       "<th align='left'>%2</th>")
                       .arg(CoverageText::tr("Storey"), CoverageText::tr("Can be reached"));
    for (const ReportSearch::Sensor& one : model.search.sensors)
        html += QStringLiteral("<th align='left'>%1</th>").arg(titleOf(one.sensor));
    html += QStringLiteral("</tr>");
    for (const ReportStorey& storey : model.storeys) {
        html += QStringLiteral("<tr><td>%1</td><td>%2</td>")
                    .arg(QString::fromStdString(storeyName(storey.share.number)),
                         CoverageText::tr("%1 m\u00B2").arg(reportNumber(storey.search.reachable, 1)));
        for (const ReportSearch::Sensor& all : model.search.sensors) {
            double seen = 0.0;
            for (const ReportSearch::Sensor& one : storey.search.sensors) {
                if (one.sensor == all.sensor) seen = one.seen;
            }
            html += QStringLiteral("<td>%1</td>").arg(share(seen, storey.search.reachable));
        }
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

}  // namespace

QString coverageHtml(const ReportContent& content) {
    const ReportSearch& search = content.model.search;
    if (!(search.reachable > 0.0)) return {};
    QString html =
        QStringLiteral("<h2>%1</h2><p>%2</p>")
            .arg(CoverageText::tr("Searched"),
                 CoverageText::tr("Of %1 m\u00B2 of floor that the robots can reach. Seen is where a "
                                  "body on the floor would span enough pixels or points.")
                     .arg(reportNumber(search.reachable, 1)));
    html += QStringLiteral(
                "<table border='1' cellspacing='0' cellpadding='4' width='100%' "
                "style='border-collapse:collapse; border-color:#999999'><tr><th align='left'>%1</th>"
                "<th align='left'>%2</th><th align='left'>%3</th></tr>")
                .arg(CoverageText::tr("Sensor"), CoverageText::tr("Seen"),
                     CoverageText::tr("Missed, the largest first"));
    for (const ReportSearch::Sensor& one : search.sensors) {
        html += QStringLiteral("<tr><td>%1</td><td>%2</td><td>%3</td></tr>")
                    .arg(titleOf(one.sensor),
                         CoverageText::tr("%1 m\u00B2, %2 %")
                             .arg(reportNumber(one.seen, 1),
                                  reportNumber(100.0 * one.seen / search.reachable, 0)),
                         missedText(one.missed, !content.model.storeys.empty()));
    }
    return html + QStringLiteral("</table>") + storeysHtml(content.model);
}

}  // namespace leitstand
