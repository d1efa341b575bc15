#include "app/options/domain_options.h"

#include <CLI/CLI.hpp>

#include "core/settings/ros_environment.h"

namespace leitstand {

void addDomainOptions(CLI::App& command, DomainOptions& options, const std::string& group) {
    const auto add = [&](CLI::Option* option, const char* type) {
        if (!group.empty()) option->group(group);
        return option->type_name(type);
    };
    add(command.add_option("--domain", options.domain, "DDS domain (as ROS_DOMAIN_ID, else 0)"), "N")
        ->check(CLI::Range(0, 232).description(""));
    add(command.add_option("--interface", options.interfaces,
                           "Network interfaces to use, by name or address (all)"),
        "NAME...");
    add(command.add_option("--peer", options.initialPeers,
                           "Addresses of robots where multicast does not pass, ADDRESS or ADDRESS:PORT (as "
                           "ROS_STATIC_PEERS)"),
        "ADDRESS...");
    add(command.add_option("--discovery-server", options.discoveryServer,
                           "Discovery servers, ADDRESS:PORT;ADDRESS:PORT (as ROS_DISCOVERY_SERVER)"),
        "LIST");
    add(command.add_option("--keys", options.keys,
                           "Take part in a secured domain with the identity of this folder, "
                           "KEYS/enclaves/NAME (see leitstandctl keys); without it security is off, unless "
                           "ROS_SECURITY_ENABLE is true"),
        "DIR");
}

Result<DomainSettings> withEnvironment(const DomainOptions& options) {
    const auto environment = rosEnvironment();
    if (!environment) return environment.error();
    return domainSettings(options, *environment);
}

}  // namespace leitstand
