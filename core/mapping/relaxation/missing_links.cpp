#include "core/mapping/relaxation/missing_links.h"

#include <map>
#include <set>
#include <string>

#include "core/event/scan_pose.h"
#include "core/mapping/live/loops/links/found_links.h"

namespace leitstand {
namespace {

/// Standard deviations of a scan's pose relative to another one: along each axis [m], of each angle [rad].
struct Deviations {
    double place, angle;
};
constexpr Deviations Matched{0.05, degrees(1.0)}, Driven{0.30, degrees(5.0)};

Link linkOf(const LiveKeyScan& from, const LiveKeyScan& to, LinkKind kind, const Deviations& deviations) {
    Link link = linkBetween(from, to, kind);
    link.information.setZero();
    link.information.diagonal().head<3>().setConstant(1.0 / (deviations.place * deviations.place));
    link.information.diagonal().tail<3>().setConstant(1.0 / (deviations.angle * deviations.angle));
    return link;
}

}  // namespace

std::vector<Link> missingLinks(const LiveMap& map, std::span<const Link> known, std::uint64_t first) {
    std::set<std::uint64_t> held;
    for (const Link& link : known) {
        if (link.active) held.insert(link.to);
    }
    std::vector<Link> links;
    std::map<std::uint64_t, const LiveKeyScan*> scans;  // by id
    std::map<std::string, const LiveKeyScan*> newest;   // by robot
    for (const LiveKeyScan& scan : map.scans) {
        if (scan.pose.trust == ScanTrust::SetAside) continue;
        const bool lacks = !held.contains(scan.id) && !scan.begins();
        const auto matched = scans.find(scan.matched);
        if (lacks && matched != scans.end())
            links.push_back(linkOf(*matched->second, scan, LinkKind::Match, Matched));
        const LiveKeyScan*& before = newest[scan.scan->robot];
        if (lacks && before != nullptr) links.push_back(linkOf(*before, scan, LinkKind::Odometry, Driven));
        before = &scan;
        scans.emplace(scan.id, &scan);
    }
    for (Link& link : links) link.id = first++;
    return links;
}

}  // namespace leitstand
