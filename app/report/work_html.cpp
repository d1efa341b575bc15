#include "app/report/work_html.h"

#include <array>
#include <chrono>
#include <utility>

#include <QCoreApplication>

#include "app/services/handin/report_text.h"

namespace leitstand {
namespace {

/// Text of the report, for translators.
struct WorkText {
    Q_DECLARE_TR_FUNCTIONS(WorkText)
};

QString item(const QString& where, const QStringList& what) {
    return QStringLiteral("<li>%1 %2</li>").arg(where, what.join(QStringLiteral("; ")) + QLatin1Char('.'));
}

QString cueText(const std::set<std::string>& kinds) {
    const std::array<std::pair<const char*, QString>, 6> names = {{{"heat", WorkText::tr("body heat")},
                                                                   {"motion", WorkText::tr("motion")},
                                                                   {"co2", WorkText::tr("CO\u2082")},
                                                                   {"code", WorkText::tr("QR codes")},
                                                                   {"tag", WorkText::tr("tags of victims")},
                                                                   {"hazard", WorkText::tr("hazard signs")}}};
    QStringList texts;
    for (const auto& [kind, name] : names) {
        if (kinds.contains(kind)) texts += name;
    }
    return texts.join(QStringLiteral(", "));
}

QStringList robotsWork(const ReportModel& model) {
    QStringList what;
    for (const ReportRobot& robot : model.robots) {
        if (robot.autonomous > std::chrono::seconds(0))
            what += WorkText::tr("%1 drove by itself for %2")
                        .arg(QString::fromStdString(robot.name).toHtmlEscaped(),
                             QString::fromStdString(spanText(robot.autonomous)).toHtmlEscaped());
    }
    if (what.isEmpty()) what += WorkText::tr("no robot drove by itself");
    if (model.work.sighted > 0)
        what += WorkText::tr("candidates that they saw by themselves: %1").arg(model.work.sighted);
    return what;
}

QStringList stationsWork(const ReportModel& model) {
    QStringList what;
    if (model.scans == 0) {
        what += WorkText::tr("there was no map to be made");
    } else {
        what += (model.work.mappedLive ? WorkText::tr("scans registered into this map while robots drove: %1")
                                       : WorkText::tr("scans registered into this map for this report: %1"))
                    .arg(model.scans);
    }
    if (model.work.believed > 0) {
        const QString cues = cueText(model.work.cues);
        what += cues.isEmpty()
                    ? WorkText::tr("candidates reported: %1").arg(model.work.believed)
                    : WorkText::tr("candidates reported: %1, by %2").arg(model.work.believed).arg(cues);
    }
    return what + QStringList(WorkText::tr("this report was written"));
}

QStringList peoplesWork(const ReportModel& model) {
    QStringList what;
    for (const ReportRobot& robot : model.robots) {
        if (robot.teleoperated > std::chrono::seconds(0))
            what += WorkText::tr("%1 was driven for %2")
                        .arg(QString::fromStdString(robot.name).toHtmlEscaped(),
                             QString::fromStdString(spanText(robot.teleoperated)).toHtmlEscaped());
    }
    const ReportWork& work = model.work;
    what += WorkText::tr("finds filed: %1, reported by a station before: %2, confirmed: %3")
                .arg(work.filed)
                .arg(work.fromCandidates)
                .arg(work.confirmed);
    if (work.scanDecisions > 0)
        what += WorkText::tr("decisions on scans and the map's area: %1").arg(work.scanDecisions);
    return what;
}

}  // namespace

QString workHtml(const ReportContent& content) {
    const ReportModel& model = content.model;
    return QStringLiteral("<ul>%1%2%3</ul>")
        .arg(item(WorkText::tr("On the robots:"), robotsWork(model)),
             item(WorkText::tr("On the operator station:"), stationsWork(model)),
             item(WorkText::tr("By people:"), peoplesWork(model)));
}

}  // namespace leitstand
