#include "app/report/changes_html.h"

#include <algorithm>

#include <QCoreApplication>
#include <QStringList>

#include "app/report/report_numbers.h"

namespace leitstand {
namespace {

/// Text of the report, for translators.
struct ChangesText {
    Q_DECLARE_TR_FUNCTIONS(ChangesText)
};

constexpr std::size_t MostListed = 25;

QString missionOf(const std::string& name) {
    return name.empty() ? ChangesText::tr("this mission") : QString::fromStdString(name).toHtmlEscaped();
}

QString rowOf(const ChangedThing& thing) {
    const Eigen::Vector3d size = thing.box.sizes(), middle = thing.box.center();
    return QStringLiteral("<tr><td>%1</td><td>%2</td><td>%3</td></tr>")
        .arg(thing.isNew ? ChangesText::tr("new") : ChangesText::tr("gone"),
             ChangesText::tr("%1 \u00D7 %2 \u00D7 %3 m")
                 .arg(reportNumber(size.x(), 1), reportNumber(size.y(), 1), reportNumber(size.z(), 1)),
             ChangesText::tr("x %1, y %2, z %3 m")
                 .arg(reportNumber(middle.x(), 2), reportNumber(middle.y(), 2),
                      reportNumber(thing.box.min().z(), 2)));
}

}  // namespace

QString changesHtml(const ReportContent& content) {
    const MapChanges& changes = content.changes;
    if (changes.compared == 0) return {};
    QStringList earlier;
    for (const std::string& name : changes.visits.earlier) earlier += missionOf(name);
    const auto came = std::count_if(changes.things.begin(), changes.things.end(),
                                    [](const ChangedThing& thing) { return thing.isNew; });
    QString html =
        QStringLiteral("<h2>%1</h2><p>%2</p>")
            .arg(ChangesText::tr("What changed"),
                 ChangesText::tr("Between %1 and %2: %3 came, %4 went. Listed is what one visit's scans have "
                                 "where the other's looked through; what was not looked at both times is not "
                                 "compared.")
                     .arg(earlier.join(QStringLiteral(", ")), missionOf(changes.visits.name))
                     .arg(came)
                     .arg(static_cast<qlonglong>(changes.things.size()) - came));
    if (changes.things.empty()) return html;
    html += QStringLiteral(
                "<table border='1' cellspacing='0' cellpadding='4' width='100%' "
                "style='border-collapse:collapse; border-color:#999999'><tr><th align='left'>%1</th>"
                "<th align='left'>%2</th><th align='left'>%3</th></tr>")
                .arg(ChangesText::tr("What"), ChangesText::tr("Size, along x, y and z"),
                     ChangesText::tr("Middle, and its lowest z"));
    for (std::size_t i = 0; i < std::min(MostListed, changes.things.size()); ++i)
        html += rowOf(changes.things[i]);
    html += QStringLiteral("</table>");
    if (changes.things.size() > MostListed)
        html += QStringLiteral("<p>%1</p>")
                    .arg(ChangesText::tr("and %1 smaller ones").arg(changes.things.size() - MostListed));
    return html;
}

}  // namespace leitstand
