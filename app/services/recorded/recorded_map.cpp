#include "app/services/recorded/recorded_map.h"

#include <string>
#include <utility>

#include "app/services/log/event_decoder.h"
#include "app/services/log/mission_robots.h"
#include "app/services/log/replay/bag_history.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/review_log.h"
#include "core/base/words.h"
#include "core/mission/state/fold.h"

namespace leitstand {

Result<RecordedMap> readMap(const std::filesystem::path& folder) {
    RecordedMap read;
    auto bag = BagReader::open(folder);
    if (!bag) return bag.error();
    if (!std::filesystem::is_directory(folder))
        return Error{
            fill(translate("leitstand::Station", "{}: expected the mission's folder"), folder.string())};
    if (isOfOthers(folder)) {
        return Error{fill(translate("leitstand::Station",
                                    "{}: no station of ours recorded it, so that it stays as it is; "
                                    "nothing can be written into it"),
                          folder.string())};
    }
    read.folder = folder;
    read.bag = std::move(bag).value();
    std::vector<std::string> ignored;
    read.robots = robotsOf(folder, *read.bag, ignored);
    EventDecoder decoder(read.robots);
    BagHistory history(*read.bag, decoder);
    read.state = stateAt(history, read.bag->lastSequence());
    return read;
}

Result<std::unique_ptr<LiveMission>> openAgain(const RecordedMap& map, LiveMissionSettings settings,
                                               LiveMissionListener listener) {
    settings.folder = map.folder;
    settings.robots = map.robots;
    const auto now = BagReader::open(map.folder);
    if (!now) return now.error();
    if ((*now)->lastSequence() != map.bag->lastSequence())
        return Error{fill(translate("leitstand::Station", "{}: somebody wrote into it meanwhile; try again"),
                          map.folder.string())};
    return LiveMission::open(settings, std::move(listener));
}

std::vector<Link> linksOf(const RecordedMap& map) {
    return linksOf(map.folder, map.state);
}

}  // namespace leitstand
