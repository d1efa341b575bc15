#include "transport/domain/join_settings.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "transport/security/enclave.h"

namespace leitstand {
namespace {

/// What to look at where the environment chose the keys.
std::string enclaveHint(const DomainSettings& settings) {
    const bool chosen = std::any_of(settings.fromEnvironment.begin(), settings.fromEnvironment.end(),
                                    [](const std::string& one) { return one.starts_with("ROS_SECURITY_"); });
    return chosen ? " (ROS_SECURITY_ENCLAVE_OVERRIDE=/NAME chooses another enclave)" : "";
}

}  // namespace

bool isSecured(const DomainSettings& settings) {
    if (settings.keys.empty() || !settings.openWithoutKeys) return !settings.keys.empty();
    // A keystore's folder of enclaves is there without an enclave of its own.
    const auto holds = [&](const char* file) {
        std::error_code problem;
        return std::filesystem::exists(settings.keys / file, problem);
    };
    return holds("cert.pem") && holds("key.pem");
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
    if (!files) return Error{files.error().text + enclaveHint(settings)};
    network.security = std::move(files).value();
    return network;
}

std::string securityLine(const DomainSettings& settings) {
    if (!isSecured(settings)) return securityLine(std::optional<SecurityFiles>());
    const auto files = securityFiles(settings.keys);
    return files ? securityLine(std::optional(*files)) : files.error().text;
}

}  // namespace leitstand
