#include "core/settings/ros_environment.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/words.h"
#include "core/settings/domain_settings.h"

namespace leitstand {
namespace {

constexpr int LastDomain = 232;  // RTPS 2.5, section 9.6.2.3: ports of later ones do not exist
constexpr const char *DomainId = "ROS_DOMAIN_ID", *LocalhostOnly = "ROS_LOCALHOST_ONLY",
                     *DiscoveryRange = "ROS_AUTOMATIC_DISCOVERY_RANGE", *StaticPeers = "ROS_STATIC_PEERS",
                     *DiscoveryServer = "ROS_DISCOVERY_SERVER", *SecurityEnable = "ROS_SECURITY_ENABLE",
                     *Keystore = "ROS_SECURITY_KEYSTORE", *Enclave = "ROS_SECURITY_ENCLAVE_OVERRIDE",
                     *Strategy = "ROS_SECURITY_STRATEGY";
constexpr const char* Localhost = "127.0.0.1";

std::optional<int> domainFrom(std::string_view text) {
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    // ROS reads 010 as 8.
    const bool whole =
        read.ec == std::errc() && read.ptr == end && (text.size() == 1 || !text.starts_with('0'));
    return whole && number >= 0 && number <= LastDomain ? std::optional(number) : std::nullopt;
}

std::vector<std::string> addressesIn(std::string_view list) {
    std::vector<std::string> addresses;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(';'), list.size());
        std::string_view one = list.substr(0, end);
        while (!one.empty() && one.front() == ' ') one.remove_prefix(1);
        while (!one.empty() && one.back() == ' ') one.remove_suffix(1);
        if (!one.empty()) addresses.emplace_back(one);
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return addresses;
}

/// Reads variables, and keeps those that are set.
class Reading {
public:
    explicit Reading(const EnvironmentReader& variable) : m_variable(variable) {}

    Result<RosEnvironment> all() {
        if (const std::string text = value(DomainId); !text.empty()) {
            m_read.domain = domainFrom(text);
            if (!m_read.domain) return wrong(DomainId, text, "0..232");
        }
        m_read.peers = addressesIn(value(StaticPeers));
        m_read.discoveryServer = value(DiscoveryServer);
        if (const Result<void> range = readRange(); !range) return range.error();
        if (const Result<void> keys = readSecurity(); !keys) return keys.error();
        return std::move(m_read);
    }

private:
    std::string value(const char* name) {
        const char* const text = m_variable(name);
        if (text == nullptr || *text == '\0') return {};
        m_read.variables.emplace(name, text);
        return text;
    }
    static Error wrong(const char* name, const std::string& text, const std::string& expected) {
        return Error{leitstand::fill(
            translate("leitstand::Error", "environment variable {}: expected {}, found \"{}\""), name,
            expected, text)};
    }

    Result<void> readRange() {
        using Range = RosEnvironment::Range;
        const std::string range = value(DiscoveryRange);
        if (range == "LOCALHOST") {
            m_read.range = Range::Localhost;
        } else if (range == "OFF") {
            m_read.range = Range::Off;
        } else if (!range.empty() && range != "SUBNET" && range != "SYSTEM_DEFAULT") {
            return wrong(DiscoveryRange, range, "SUBNET, LOCALHOST, OFF, SYSTEM_DEFAULT");
        }
        const std::string only = value(LocalhostOnly);
        if (only == "1") {  // goes before the two others, as in ROS
            m_read.localhostOnly = true;
            m_read.range = Range::Localhost;
            m_read.peers.clear();
        } else if (!only.empty() && only != "0") {
            return wrong(LocalhostOnly, only, "0, 1");
        }
        return {};
    }

    Result<void> readSecurity() {
        const std::string enabled = value(SecurityEnable);
        if (enabled != "true") return {};
        m_read.enforced = value(Strategy) == "Enforce";
        const std::string keystore = value(Keystore), enclave = value(Enclave);
        if (keystore.empty()) {
            if (!m_read.enforced) return {};
            return wrong(Keystore, {}, translate("leitstand::Error", "the folder of a keystore"));
        }
        if (!enclave.empty() && enclave.front() != '/') return wrong(Enclave, enclave, "/NAME");
        m_read.keys = std::filesystem::path(keystore) / "enclaves" / enclave.substr(enclave.empty() ? 0 : 1);
        return {};
    }

    const EnvironmentReader& m_variable;
    RosEnvironment m_read;
};

/// Fills in what options leave open.
class Settling {
public:
    Settling(const DomainOptions& options, const RosEnvironment& environment)
        : m_options(options), m_environment(environment) {}

    Result<DomainSettings> settled() {
        m_settings.domain = m_options.domain.value_or(m_environment.domain.value_or(0));
        if (!m_options.domain && m_environment.domain) decided(DomainId);
        m_settings.interfaces = m_options.interfaces;
        m_settings.initialPeers = m_options.initialPeers;
        m_settings.discoveryServer = m_options.discoveryServer;
        // Options that say whom to find go before all variables that do.
        if (m_options.interfaces.empty() && m_options.initialPeers.empty() &&
            m_options.discoveryServer.empty()) {
            if (m_environment.range == RosEnvironment::Range::Off)
                return Error{leitstand::fill(
                    translate("leitstand::Error",
                              "environment variable {}: with {} no robot can be found; unset it, or name a "
                              "network card (--interface) or an address (--peer)"),
                    DiscoveryRange, "OFF")};
            findByEnvironment();
        }
        m_settings.keys = m_options.keys;
        if (m_options.keys.empty() && !m_environment.keys.empty()) {
            m_settings.keys = m_environment.keys;
            m_settings.openWithoutKeys = !m_environment.enforced;
            decided(Keystore);
            decided(Enclave);
        }
        return std::move(m_settings);
    }

private:
    void findByEnvironment() {
        m_settings.discoveryServer = m_environment.discoveryServer;
        decided(DiscoveryServer);
        m_settings.initialPeers = m_environment.peers;
        if (!m_environment.peers.empty()) decided(StaticPeers);
        if (m_environment.localhostOnly) {
            m_settings.interfaces = {"lo"};
            decided(LocalhostOnly);
            return;
        }
        // A server says who is there, whatever the range.
        if (m_environment.range != RosEnvironment::Range::Localhost || !m_environment.discoveryServer.empty())
            return;
        decided(DiscoveryRange);
        if (m_environment.peers.empty()) {
            m_settings.interfaces = {"lo"};
            return;
        }
        m_settings.initialPeers.emplace_back(Localhost);
        m_settings.multicast = false;
    }
    void decided(const char* name) {
        const auto variable = m_environment.variables.find(name);
        if (variable != m_environment.variables.end())
            m_settings.fromEnvironment.push_back(variable->first + "=" + variable->second);
    }

    const DomainOptions& m_options;
    const RosEnvironment& m_environment;
    DomainSettings m_settings;
};

}  // namespace

Result<DomainSettings> domainSettings(const DomainOptions& options, const RosEnvironment& environment) {
    return Settling(options, environment).settled();
}

std::string environmentLine(const DomainSettings& settings) {
    if (settings.fromEnvironment.empty()) return {};
    return fmt::format("by ROS's environment: {}", fmt::join(settings.fromEnvironment, ", "));
}

Result<RosEnvironment> rosEnvironment(const EnvironmentReader& variable) {
    return Reading(variable).all();
}

Result<RosEnvironment> rosEnvironment() {
    auto environment = rosEnvironment([](const char* name) { return std::getenv(name); });
    unsetenv(DiscoveryServer);
    return environment;
}

}  // namespace leitstand
