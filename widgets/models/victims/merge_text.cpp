#include "widgets/models/victims/merge_text.h"

#include <QCoreApplication>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct MergeWords {
    Q_DECLARE_TR_FUNCTIONS(leitstand::MergeWords)
};

}  // namespace

MergeOffer mergeOffer(const MissionState& state, const FindKey& find) {
    const auto into = nearestOfKind(state, find);
    if (!into) return {std::nullopt, MergeWords::tr("There is no other find of this kind to merge it with")};
    const QString one = QString::fromStdString(nameOf(find.first, find.second));
    const QString other = QString::fromStdString(nameOf(find.first, into->find.second));
    const QString apart = numberText(into->distance, 1);
    if (into->distance > MergeReach) {
        return {std::nullopt,
                MergeWords::tr("%1, the nearest to %2, is %3 m away from it: move one of them there first")
                    .arg(other, one, apart)};
    }
    return {into->find.second, MergeWords::tr("%1 is part of %2 now, %3 m away").arg(one, other, apart)};
}

}  // namespace leitstand
