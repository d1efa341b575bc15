#include "app/report/evidence_html.h"

#include <cmath>

#include <QCoreApplication>

#include "app/report/report_numbers.h"
#include "app/report/report_times.h"
#include "core/base/rotation/heading.h"

namespace leitstand {
namespace {

/// Text on evidence, for translators.
struct EvidenceText {
    Q_DECLARE_TR_FUNCTIONS(EvidenceText)
};

QString captionOf(const EvidencePicture& picture) {
    QString text = QStringLiteral("%1 %2, %3")
                       .arg(QString::fromStdString(picture.robot), QString::fromStdString(picture.sensor),
                            reportClock(picture.at));
    if (picture.hottest)
        text += EvidenceText::tr(", 15 to 40 °C, hottest %1 °C").arg(reportNumber(*picture.hottest, 1));
    return text;
}

QString captionOf(const FrozenScan& scan) {
    return EvidenceText::tr(
               "scan of %1, %2, from above: the disc is the find, the arrow the robot; yellow is "
               "high; lines are 1 m apart")
        .arg(QString::fromStdString(scan.robot), reportClock(scan.at));
}

QString lineOf(const FrozenScan& scan) {
    const QString robot = QString::fromStdString(scan.robot), at = reportClock(scan.at),
                  points = QString::number(scan.points);
    if (scan.keyScan != 0)
        return EvidenceText::tr("scan %1 of %2 at %3, %4 points").arg(scan.keyScan).arg(robot, at, points);
    return EvidenceText::tr("scan of %1 at %2, %3 points").arg(robot, at, points);
}

QString lineOf(const FrozenPose& pose) {
    const QString robot = QString::fromStdString(pose.robot), at = reportClock(pose.at);
    const Pose& shown = pose.inMap ? *pose.inMap : pose.inOdom;
    const QString x = reportNumber(shown.translation().x(), 2), y = reportNumber(shown.translation().y(), 2),
                  heading = reportNumber(inDegrees(headingOf(shown)), 0);
    return pose.inMap ? EvidenceText::tr("%1 stood at x %2, y %3 m, heading %4° in the map, at %5")
                            .arg(robot, x, y, heading, at)
                      : EvidenceText::tr(
                            "%1 stood at x %2, y %3 m of its odometry, heading %4°, at %5: its place in "
                            "the map is not known")
                            .arg(robot, x, y, heading, at);
}

}  // namespace

std::vector<PrintedPicture> printedPictures(const FindPages& pages) {
    std::vector<PrintedPicture> printed;
    for (const EvidencePicture& picture : pages.pictures)
        printed.push_back({captionOf(picture), &picture.picture});
    for (const FrozenScan& scan : pages.scans) {
        if (!scan.picture.picture.bytes.empty()) printed.push_back({captionOf(scan), &scan.picture.picture});
    }
    return printed;
}

QStringList evidenceLines(const FindPages& pages) {
    QStringList lines;
    for (const GasTrace& trace : pages.gas) {
        const GasTrace::Reading& newest = trace.readings.back();
        lines += EvidenceText::tr("CO₂ %1 ppm at %2 (%3)")
                     .arg(reportNumber(newest.ppm, 0), reportClock(newest.at),
                          QString::fromStdString(trace.robot));
    }
    for (const FrozenScan& scan : pages.scans) lines += lineOf(scan);
    for (const FrozenPose& pose : pages.poses) lines += lineOf(pose);
    if (pages.morePictures > 0)
        lines += EvidenceText::tr("more pictures, in the mission: %1").arg(pages.morePictures);
    return lines;
}

}  // namespace leitstand
