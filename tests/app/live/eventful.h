#pragma once

#include "app/services/finds/find_desk.h"
#include "app/services/station/safety/station_alarms.h"
#include "app/services/station/station.h"
#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"

namespace leitstand::test {

/// Lets @p station have what lists show when much has happened: a stop that nobody answers, which is an alarm
/// of each robot, and finds of all kinds. @p soon: QTest::qWaitFor or the like.
template <class Soon>
[[nodiscard]] bool makeEventful(Station& station, Soon soon) {
    using Kind = FindSample::Kind;
    station.stopAll();
    double x = 1.0;
    for (const Kind kind : {Kind::Victim, Kind::Victim, Kind::Hazard, Kind::Code, Kind::Object}) {
        station.finds().freezeAt("kurt3d", kind, {x, 10.0 - x, 0.2});
        x += 2.5;
    }
    return soon([&] {
        return station.mission()->finds->size() >= 5 &&
               station.alarms().view().alarms.size() >= station.robots().size();
    });
}

}  // namespace leitstand::test
