#include "widgets/models/victims/move_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "widgets/models/numbers.h"
#include "widgets/models/times.h"

namespace leitstand {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::FindMoves)
};

}  // namespace

QString causeText(FindMove::Cause cause) {
    switch (cause) {
        case FindMove::Cause::Registration:
            return Texts::tr("scans were registered again");
        case FindMove::Cause::LoopClosure:
            return Texts::tr("a loop was closed");
        case FindMove::Cause::Operator:
            return Texts::tr("the operator corrected scans");
        case FindMove::Cause::Undo:
            break;
    }
    return Texts::tr("a decision was taken back");
}

QString movedText(const FindMove& move) {
    return Texts::tr("moved %1 m at %2, since %3")
        .arg(numberText(move.metres(), 2), wallText(move.at), causeText(move.cause));
}

QString movesText(const std::vector<FindMove>& moves) {
    if (moves.empty()) return {};
    QStringList finds;
    for (const FindMove& move : moves)
        finds += Texts::tr("%1 %2 m", "V1 0.32 m")
                     .arg(QString::fromStdString(nameOf(move.find.first, move.find.second)),
                          numberText(move.metres(), 2));
    return Texts::tr("%1 moved, since %2")
        .arg(finds.join(QStringLiteral(", ")), causeText(moves.back().cause));
}

}  // namespace leitstand
