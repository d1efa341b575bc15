#include "core/io/bag/topic_info.h"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace leitstand {

namespace {

/// Formats a duration as rmw does; 0 or less is infinite [s].
std::string duration(const char* name, double seconds) {
    constexpr std::uint64_t Infinite = 9223372036ULL;
    const bool infinite = !(seconds > 0.0) || seconds >= 9e9;
    const double whole = infinite ? 0.0 : std::floor(seconds);
    const auto rest = static_cast<std::uint64_t>(infinite ? 0.0 : (seconds - whole) * 1e9);
    return fmt::format("  {}:\n    sec: {}\n    nsec: {}\n", name,
                       infinite ? Infinite : static_cast<std::uint64_t>(whole), infinite ? 854775807U : rest);
}

}  // namespace

std::string qosProfilesOf(const Qos& qos) {
    // The numbers of rmw's enumerations: 1 keep_last, reliable, transient_local, automatic; 2 the others.
    std::string yaml =
        fmt::format("- history: {}\n  depth: {}\n  reliability: {}\n  durability: {}\n",
                    qos.depth > 0 ? 1 : 2, qos.depth, qos.reliability == Qos::Reliability::Reliable ? 1 : 2,
                    qos.durability == Qos::Durability::TransientLocal ? 1 : 2);
    yaml += duration("deadline", qos.deadline);
    yaml += duration("lifespan", qos.lifespan);
    yaml += "  liveliness: 1\n";
    yaml += duration("liveliness_lease_duration", 0.0);
    yaml += "  avoid_ros_namespace_conventions: false";
    return yaml;
}

}  // namespace leitstand
