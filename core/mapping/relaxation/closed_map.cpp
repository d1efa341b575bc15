#include "core/mapping/relaxation/closed_map.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/mapping/live/live_mapper.h"
#include "core/mapping/relocalisation/place_recognition.h"

namespace leitstand {
namespace {

constexpr double ClosingShare = 0.5;  ///< share of the work; the rest is relaxation
/// Deviations of a pose that is given by hand [m], [rad]; matches hold more, where they fit.
constexpr double GivenWithin = 0.1, GivenWithinAngle = degrees(2.0);

Result<void> check(std::span<const GivenLink> given, std::size_t scans) {
    for (const GivenLink& one : given) {
        if (one.from >= scans || one.to >= scans)
            return Error{fmt::format("scans {} and {}: expected two of the {} scans, from 0", one.from,
                                     one.to, scans)};
        if (one.from == one.to)
            return Error{fmt::format("scan {}: expected another scan beside it", one.from)};
    }
    return {};
}

Link linkOf(const GivenLink& given) {
    Link link;
    link.kind = LinkKind::Operator;
    link.active = given.toInFrom.has_value();
    link.pose = given.toInFrom.value_or(Pose::Identity());
    link.information.setZero();
    link.information.diagonal().head<3>().setConstant(1.0 / (GivenWithin * GivenWithin));
    link.information.diagonal().tail<3>().setConstant(1.0 / (GivenWithinAngle * GivenWithinAngle));
    return link;
}

/// Maps a row of scans; all of them enter.
class Closing {
public:
    Closing(const Map& map, std::span<const GivenLink> given, LiveSettings settings)
        : m_map(map), m_settings(std::move(settings)), m_mapper("register", entering(m_settings)) {
        m_given.assign(given.begin(), given.end());
    }

    void add(std::size_t place, const Progress& progress) {
        const MapScan& entry = m_map.scans[place];
        LiveScan live;
        Scan scan = *entry.scan;
        scan.robot = "register";
        scan.hasOdometry = true;
        scan.sensorInOdom = entry.poseInMap;
        live.scan = std::make_shared<const Scan>(std::move(scan));
        if (place > 0) {
            const Pose& before = m_map.scans[place - 1].poseInMap;
            live.way = distanceBetween(before, entry.poseInMap);
            live.turn = angleBetween(before, entry.poseInMap);
        }
        m_now += std::chrono::seconds(1);
        const MapUpdate update = m_mapper.add(live, m_now);
        if (update.keyScan && update.keyScan->id == 1) begin(place);
        if (update.links)
            m_links.insert(m_links.end(), update.links->links.begin(), update.links->links.end());
        if (update.loop) found(*update.loop);
        seek(progress);
        for (const GivenLink& one : m_given) {
            if (one.toInFrom && std::max(one.from, one.to) == place) keep(one);
        }
        settle();
    }

    [[nodiscard]] ClosedMap relaxed(const RelaxationSettings& how, const Progress& progress) {
        const LiveMapPtr map = m_mapper.map();
        m_result.relaxation = relax(*map, m_links, m_settings, how, progress);
        if (progress.cancelled()) return {};
        for (const std::uint64_t id : m_result.relaxation.contradicted) contradict(id);
        std::map<std::uint64_t, Pose> poses;
        for (const GraphNode& node : m_result.relaxation.nodes) poses.emplace(node.id, node.pose);
        if (poses.empty()) return std::move(m_result);
        // The mapper's map begins with the first scan that entered.
        const Pose first = m_map.scans[m_first].poseInMap;
        Pose correction = Pose::Identity();  // scans that did not enter move with the one before
        for (std::size_t i = 0; i < m_map.scans.size(); ++i) {
            const Pose& before = m_map.scans[i].poseInMap;
            const auto known = poses.find(idOf(i));
            if (known != poses.end()) correction = first * known->second * before.inverse();
            m_result.poses.push_back(correction * before);
        }
        return std::move(m_result);
    }

private:
    static LiveSettings entering(LiveSettings settings) {
        settings.keyScans.distance = settings.keyScans.angle = 0.0;  // all of them
        settings.loops.noticed = settings.loops.noticedAngle = 0.0;
        return settings;
    }
    /// Returns the scan's id in the mapper; 0: it did not enter.
    [[nodiscard]] std::uint64_t idOf(std::size_t place) const {
        return place < m_first ? 0 : place - m_first + 1;
    }
    [[nodiscard]] std::size_t placeOf(std::uint64_t id) const { return m_first + id - 1; }
    /// Begins the map with the scan at @p place: those before have too few points. All later ones enter.
    void begin(std::size_t place) {
        m_first = place;
        // Places that are given as different must be known before the search.
        for (const GivenLink& one : m_given) {
            if (!one.toInFrom) keep(one);
        }
    }
    void keep(const GivenLink& given) {
        Link link = linkOf(given);
        link.from = idOf(given.from);
        link.to = idOf(given.to);
        if (link.from == 0 || link.to == 0) {
            ++m_result.unused;
            return;
        }
        // The mapper continues the ids from here.
        for (const Link& known : m_links) link.id = std::max(link.id, known.id);
        ++link.id;
        m_links.push_back(link);
        m_mapper.restore(ScanLinksSample{m_now, "register", {link}});
    }
    void found(const ScanLinksSample& loop) {
        const Link& first = loop.links.front();
        const SamePlace same{placeOf(first.from), placeOf(first.to), shiftOf(first), first.id};
        (first.active ? m_result.closed : m_result.unsure).push_back(same);
        m_links.insert(m_links.end(), loop.links.begin(), loop.links.end());
    }
    /// Returns how far the map has the scans of @p link from where they see each other [m].
    [[nodiscard]] double shiftOf(const Link& link) const {
        const LiveMapPtr map = m_mapper.map();
        Pose from = Pose::Identity(), to = Pose::Identity();
        for (const LiveKeyScan& scan : map->scans) {
            if (scan.id == link.from) from = scan.pose.scanInMap;
            if (scan.id == link.to) to = scan.pose.scanInMap;
        }
        return distanceBetween(from * link.pose, to);
    }
    /// Looks for a place where the path meets itself, far from the scan's pose in the map.
    void seek(const Progress& progress) {
        const auto sought = m_mapper.sought();
        const auto place = sought ? recognise(*sought, m_settings, {}, {{}, progress.stop}) : std::nullopt;
        if (!place) return;
        if (const auto loop = m_mapper.recognised(*sought, *place, m_now)) found(*loop);
    }
    void settle() {
        const auto problem = m_mapper.problem();
        if (!problem) return;
        const Settled settled = m_mapper.settle(solve(*problem), m_now);
        if (!settled.links) return;
        for (const Link& link : settled.links->links) {
            for (Link& known : m_links) {
                if (known.id == link.id) known.active = link.active;
            }
            contradict(link.id);
        }
    }
    /// Moves the loop with the link @p id to those that the rest contradicts.
    void contradict(std::uint64_t id) {
        auto& closed = m_result.closed;
        const auto one = std::find_if(closed.begin(), closed.end(),
                                      [id](const SamePlace& place) { return place.link == id; });
        if (one == closed.end()) return;
        m_result.contradicted.push_back(*one);
        closed.erase(one);
    }

    const Map& m_map;
    LiveSettings m_settings;
    LiveMapper m_mapper;
    std::vector<GivenLink> m_given;
    std::vector<Link> m_links;
    std::size_t m_first = std::numeric_limits<std::size_t>::max();  ///< place of the first that entered
    Time m_now{};
    ClosedMap m_result;
};

}  // namespace

Result<ClosedMap> closeLoops(const Map& map, std::span<const GivenLink> given, const LiveSettings& settings,
                             const RelaxationSettings& how, const Progress& progress) {
    if (auto checked = check(given, map.scans.size()); !checked) return checked.error();
    Closing closing(map, given, settings);
    for (std::size_t i = 0; i < map.scans.size(); ++i) {
        if (progress.cancelled()) return ClosedMap{};
        closing.add(i, progress);
        progress.done(ClosingShare * double(i + 1) / double(map.scans.size()));
    }
    const Progress relaxing{
        [&](double fraction) { progress.done(ClosingShare + (1.0 - ClosingShare) * fraction); },
        progress.stop};
    return closing.relaxed(how, relaxing);
}

}  // namespace leitstand
