#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "core/event/event.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/mission/state/fold.h"

namespace leitstand::test {

/// A moment of the tests' station, @p milliseconds after its mission began.
[[nodiscard]] Time at(std::int64_t milliseconds);
/// @p sample as event @p sequence, of @p robot (empty: the station's own).
[[nodiscard]] Event event(std::uint64_t sequence, Sample sample, const std::string& robot = {});
/// A victim as filed, a pose of a key scan, an undo.
[[nodiscard]] FindSample victim(std::uint32_t number, const std::string& text);
[[nodiscard]] ScanPosesSample moved(std::uint64_t scan, double x);
/// Of the scans 1 and 2, which @p kind tells; the link's id is @p id.
[[nodiscard]] ScanLinksSample linked(std::uint64_t id, LinkKind kind, bool active = true);
[[nodiscard]] KeyScanSample keyScan(std::uint64_t id, double x);
[[nodiscard]] UndoSample undo(std::uint64_t sequence);

/// A random mission: everything a fold handles, in any order, with undo of whatever comes to mind.
[[nodiscard]] std::vector<Event> randomMission(unsigned seed, std::size_t events);

/// A log in memory that holds @p events and a checkpoint every so often.
class MemoryHistory final : public MissionHistory {
public:
    explicit MemoryHistory(std::vector<Event> events) : m_events(std::move(events)) {}
    [[nodiscard]] std::optional<StoredCheckpoint> checkpointUpTo(std::uint64_t sequence) override;
    void events(std::uint64_t after, std::uint64_t upTo,
                const std::function<void(const Event&)>& take) override;
    [[nodiscard]] std::size_t given() const { return m_given; }  ///< events that were asked for

private:
    std::vector<Event> m_events;
    std::size_t m_given = 0;
};

}  // namespace leitstand::test
