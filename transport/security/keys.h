#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// Rights of the owner of an identity in a secured domain; permissionsXml() spells them out.
enum class KeyRole : std::uint8_t {
    Station,  ///< reads everything, commands every robot, writes the station's own topics
    Robot,    ///< publishes below its own name, reads what is addressed to it
    Viewer,   ///< reads everything, may stop robots and ping them, nothing else
};
[[nodiscard]] std::string toString(KeyRole role);  ///< "station", "robot", "viewer"

/// An identity to be made.
struct KeyRequest {
    KeyRole role = KeyRole::Viewer;
    std::string name;  ///< letters, digits, '_', no digit first, at most 32; a robot's: its name in topics
    /// DDS topics that it may publish and read beyond those of its role, "rt/scan" or "rt/arm/*". For robots
    /// whose topics are not below their name.
    std::vector<std::string> moreTopics;
    bool commandsItself = false;  ///< a robot that publishes its own command topics (navigation on board)
};

/// How identities are made.
struct KeySettings {
    int days = 365;             ///< validity of an identity and its permissions [days]
    int authorityDays = 3'650;  ///< validity of authorities [days]; at least that of identities
    bool renew = false;         ///< replaces identities that exist; the old ones are kept in retired/
    Time now = std::chrono::system_clock::now();  ///< validity begins a day earlier, for slow clocks
};

/// An identity in a keystore.
struct KeyInfo {
    KeyRole role = KeyRole::Viewer;
    std::string name;
    std::string serial;              ///< number of its certificate, hexadecimal
    Time validFrom{}, validUntil{};  ///< of its certificate
    std::filesystem::path enclave;   ///< the folder that goes to its machine
    bool revoked = false;
    std::string problem;  ///< why it cannot be used now; empty when all is well
};

/// Content of a keystore.
struct Keystore {
    std::filesystem::path folder;
    Time authorityValidUntil{};
    std::vector<KeyInfo> identities;    ///< by name
    std::vector<std::string> warnings;  ///< "private/identity_ca.key.pem: readable by others ..."
};

/// Makes @p requests in the keystore @p folder; makes the keystore with its two authorities first when there
/// is none. The layout is that of ROS 2 (sros2): public/, private/, enclaves/<name>/. Keys are files of mode
/// 0600 and are never overwritten. Identities and permissions have an authority each; with only one, the
/// owner of an identity could sign permissions for himself. All requests are checked before anything is
/// written, and each enclave appears whole or not at all. Errors name the file or the name.
[[nodiscard]] Result<std::vector<KeyInfo>> createKeys(const std::filesystem::path& folder,
                                                      const std::vector<KeyRequest>& requests,
                                                      const KeySettings& settings = {});

/// Reads the keystore @p folder; the private keys of the authorities are not read.
[[nodiscard]] Result<Keystore> readKeystore(const std::filesystem::path& folder,
                                            Time now = std::chrono::system_clock::now());

/// Revokes the certificates of @p name, also its retired ones. Writes a revocation list into every
/// identity_ca.cert.pem of the keystore and moves the enclave to retired/. The revocation takes effect on a
/// machine that has the new identity_ca.cert.pem, once the program there is restarted. Returns the number of
/// certificates that were revoked now; error when there is none.
[[nodiscard]] Result<int> revokeKeys(const std::filesystem::path& folder, const std::string& name,
                                     Time now = std::chrono::system_clock::now());

}  // namespace leitstand
