#include "app/cli/options/domain_options.h"

#include <CLI/CLI.hpp>

namespace leitstand::cli {

void addDomainOptions(CLI::App& command, DomainSettings& settings) {
    command.add_option("--domain", settings.domain, "DDS domain, as ROS_DOMAIN_ID (0)")
        ->check(CLI::Range(0, 232));
    command
        .add_option("--interface", settings.interfaces, "Network interfaces to use, by name or address (all)")
        ->type_name("NAME...");
    command
        .add_option("--peer", settings.initialPeers,
                    "Addresses of robots where multicast does not pass, ADDRESS or ADDRESS:PORT")
        ->type_name("ADDRESS...");
    command
        .add_option("--discovery-server", settings.discoveryServer,
                    "Discovery servers, as ROS_DISCOVERY_SERVER: ADDRESS:PORT;ADDRESS:PORT")
        ->type_name("LIST");
    command
        .add_option("--keys", settings.keys,
                    "Take part in a secured domain with the identity of this folder, KEYS/enclaves/NAME (see "
                    "leitstandctl keys); without it security is off")
        ->type_name("DIR");
}

}  // namespace leitstand::cli
