#include "app/services/by_hand/map_by_hand.h"

#include <algorithm>
#include <cstdint>
#include <future>
#include <utility>

#include "app/services/log/live_mission.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/recorded_map.h"
#include "core/base/words.h"
#include "core/event/event.h"
#include "core/io/page_file.h"
#include "core/mission/state/decision.h"

namespace leitstand {

MapByHand::MapByHand(std::filesystem::path folder, std::vector<RobotDescription> robots)
    : m_folder(std::move(folder)), m_robots(std::move(robots)) {}

MapByHand::~MapByHand() {
    (void)close();
}

Result<std::unique_ptr<MapByHand>> MapByHand::open(const std::filesystem::path& folder,
                                                   const std::string& station, const std::string& version,
                                                   StationMappingListener listener) {
    auto read = readMap(folder);
    if (!read) return read.error();
    StationMappingSetup setup;
    setup.robots = read->robots;
    setup.station = station;
    setup.earlier = keyScansOf(*read->bag);
    setup.earlierLinks = scanLinksOf(read->folder);
    setup.mission = read->folder;
    if (setup.earlier.empty())
        return Error{fill(translate("leitstand::Station", "{}: expected a map of ours, found no key scans"),
                          folder.string())};
    if (setup.earlierLinks.empty() && setup.earlier.size() > 1)
        return Error{fill(translate("leitstand::Station",
                                    "{}: nothing tells how its scans hang together: tidy the map first"),
                          folder.string())};
    if (auto pages = PageFile::open(read->folder)) setup.settings.pages = std::move(pages).value();
    std::unique_ptr<MapByHand> hand(new MapByHand(read->folder, read->robots));
    LiveMissionSettings log;
    log.station = station;
    log.title = "Map by hand";
    log.version = version;
    LiveMissionListener missionListener;
    missionListener.onAlarm = listener.onMessage;
    missionListener.onEvent = [raw = hand.get()](const Event& event) {
        if (StationMapping* const mapping = raw->m_listening) mapping->onEvent(event);
    };
    auto mission = openAgain(*read, log, std::move(missionListener));
    if (!mission) return mission.error();
    hand->m_mission = std::move(mission).value();
    hand->m_before = read->state.sequence;
    hand->m_mapping = std::make_unique<StationMapping>(
        *hand->m_mission, [] { return true; }, std::move(setup), std::move(listener));
    hand->m_listening = hand->m_mapping.get();
    return hand;
}

MissionStatePtr MapByHand::state() const {
    return m_mission->state();
}

bool MapByHand::decided() const {
    const MissionStatePtr now = state();
    return std::any_of(now->decisions->begin(), now->decisions->end(),
                       [&](const Decision& one) { return one.sequence > m_before; });
}

Result<void> MapByHand::close() {
    if (!m_mission || !m_mapping || m_listening == nullptr) return {};
    // What the mapping publishes comes back as events, and may be followed by more.
    std::uint64_t before = 0;
    Result<void> written = m_mission->flush();
    do {
        before = state()->sequence;
        std::promise<void> calm;
        m_mapping->whenCalm([&calm] { calm.set_value(); });
        calm.get_future().wait();
        written = m_mission->flush();
    } while (written && state()->sequence != before);
    m_listening = nullptr;
    m_mapping->close();
    const Result<void> closed = m_mission->close();
    return written ? closed : written;
}

}  // namespace leitstand
