#include "widgets/models/live/wire_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace leitstand {
namespace {

struct WireWords {
    Q_DECLARE_TR_FUNCTIONS(leitstand::WireWords)
};

QString problemText(const WireProblem& problem) {
    using Kind = WireProblem::Kind;
    const QString theirs = QString::fromStdString(problem.theirs),
                  ours = QString::fromStdString(problem.ours);
    switch (problem.kind) {
        case Kind::OffersLess:
            return WireWords::tr("robot offers %1, we asked for %2").arg(theirs, ours);
        case Kind::AsksMore:
            return WireWords::tr("we offer %1, robot asks for %2").arg(ours, theirs);
        case Kind::SendsOther:
            return WireWords::tr("robot sends %1, we expected %2").arg(theirs, ours);
        case Kind::ExpectsOther:
            return WireWords::tr("robot expects %1, we send %2").arg(theirs, ours);
        case Kind::Keyed:
            return WireWords::tr("robot's topic has keys, ours has none as in ROS 2");
        case Kind::OffersExclusive:
            return WireWords::tr("robot offers exclusive ownership, we share as ROS 2 does");
        case Kind::AsksExclusive:
            return WireWords::tr("robot asks for exclusive ownership, we share as ROS 2 does");
        case Kind::Partition:
            return WireWords::tr("robot is in partition \"%1\", we are in the default one").arg(theirs);
        case Kind::WritesXcdr2:
            return WireWords::tr("robot writes XCDR2 only, we read XCDR1");
        case Kind::ReadsXcdr2:
            return WireWords::tr("robot reads XCDR2 only, we write XCDR1");
        case Kind::Liveliness:
            return WireWords::tr("robot asks for a liveliness that we do not offer");
        case Kind::Security:
            return WireWords::tr("security: permissions or governance of one side do not let them talk");
    }
    return {};
}

}  // namespace

QString wireText(const WireComplaint& complaint) {
    QStringList problems;
    for (const WireProblem& problem : complaint.problems) problems += problemText(problem);
    return QString::fromStdString(complaint.topic) + QStringLiteral(": ") +
           problems.join(QStringLiteral("; "));
}

}  // namespace leitstand
