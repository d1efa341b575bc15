#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {

const std::vector<Conversion>& conversions() {
    static const std::vector<Conversion> all = [] {
        std::vector<Conversion> rows;
        for (const auto& some :
             {cloudConversions(), motionConversions(), navigationConversions(), pictureConversions(),
              statusConversions(), commandConversions(), jointConversions(), mapConversions(),
              markerConversions(), stationConversions(), victimConversions()})
            rows.insert(rows.end(), some.begin(), some.end());
        return rows;
    }();
    return all;
}

}  // namespace leitstand::detail
