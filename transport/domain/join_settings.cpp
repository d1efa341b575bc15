#include "transport/domain/join_settings.h"

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "transport/security/enclave.h"

namespace leitstand {

bool isSecured(const DomainSettings& settings) {
    std::error_code problem;
    return !settings.keys.empty() &&
           (!settings.openWithoutKeys || std::filesystem::exists(settings.keys, problem));
}

Result<NodeSettings> nodeSettings(const DomainSettings& settings, const std::string& name) {
    NodeSettings network;
    network.domain = settings.domain;
    network.name = name;
    network.interfaces = settings.interfaces;
    network.initialPeers = settings.initialPeers;
    network.multicast = settings.multicast;
    network.discoveryServer = settings.discoveryServer;
    if (!isSecured(settings)) return network;
    auto files = securityFiles(settings.keys);
    if (!files) return files.error();
    network.security = std::move(files).value();
    return network;
}

std::string securityLine(const DomainSettings& settings) {
    if (!isSecured(settings)) return securityLine(std::optional<SecurityFiles>());
    const auto files = securityFiles(settings.keys);
    return files ? securityLine(std::optional(*files)) : files.error().text;
}

}  // namespace leitstand
