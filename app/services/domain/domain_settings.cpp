#include "app/services/domain/domain_settings.h"

#include <optional>
#include <utility>

#include "transport/dds/node_settings.h"
#include "transport/security/enclave.h"

namespace leitstand {

Result<NodeSettings> nodeSettings(const DomainSettings& settings, const std::string& name) {
    NodeSettings network;
    network.domain = settings.domain;
    network.name = name;
    network.interfaces = settings.interfaces;
    network.initialPeers = settings.initialPeers;
    network.discoveryServer = settings.discoveryServer;
    if (settings.keys.empty()) return network;
    auto files = securityFiles(settings.keys);
    if (!files) return files.error();
    network.security = std::move(files).value();
    return network;
}

std::string securityLine(const DomainSettings& settings) {
    if (settings.keys.empty()) return securityLine(std::optional<SecurityFiles>());
    const auto files = securityFiles(settings.keys);
    return files ? securityLine(std::optional(*files)) : files.error().text;
}

}  // namespace leitstand
