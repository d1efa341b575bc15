#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// What the owner of an identity may do in a secured domain; permissionsXml() has the details.
enum class KeyRole : std::uint8_t {
    Station,  ///< reads everything, commands every robot, writes the station's own topics
    Robot,    ///< publishes below its own name, reads what is addressed to it
    Viewer,   ///< reads everything and may stop and ping robots, but nothing else
};
[[nodiscard]] std::string toString(KeyRole role);  ///< "station", "robot", "viewer"

/// An identity to be made.
struct KeyRequest {
    KeyRole role = KeyRole::Viewer;
    /// Letters, digits and '_', not beginning with a digit, at most 32; for a robot, its name in topics.
    std::string name;
    /// DDS topics that it may publish and read in addition to those of its role, "rt/scan" or "rt/arm/*". For
    /// robots whose topics are not below their name.
    std::vector<std::string> moreTopics;
    bool commandsItself = false;  ///< whether a robot publishes its own command topics (navigation on board)
};

/// How identities are made.
struct KeySettings {
    int days = 365;             ///< validity of an identity and its permissions [days]
    int authorityDays = 3'650;  ///< validity of authorities [days]; at least that of identities
    bool renew = false;         ///< whether identities that exist are replaced; old ones are kept in retired/
    /// Time of creation; validity begins a day earlier, for clocks that are slow.
    Time now = std::chrono::system_clock::now();
};

/// An identity in a keystore.
struct KeyInfo {
    KeyRole role = KeyRole::Viewer;
    std::string name;
    std::string serial;              ///< serial number of its certificate, hexadecimal
    Time validFrom{}, validUntil{};  ///< validity of its certificate
    std::filesystem::path enclave;   ///< folder that must be copied to its machine
    bool revoked = false;
    std::string problem;  ///< why it cannot be used now; empty: it can
};

/// Content of a keystore.
struct Keystore {
    std::filesystem::path folder;
    Time authorityValidUntil{};
    std::vector<KeyInfo> identities;    ///< by name
    std::vector<std::string> warnings;  ///< "private/identity_ca.key.pem: readable by others ..."
};

/// Makes @p requests in the keystore @p folder. If there is none, first makes it with its two authorities.
/// The layout is that of ROS 2 (sros2): public/, private/, enclaves/<name>/. Keys are files with mode 0600
/// and are never overwritten. Identities and permissions have separate authorities; with only one, the owner
/// of an identity could sign his own permissions. All requests are checked before anything is written, and
/// each enclave appears completely or not at all. Errors name the file or the name.
[[nodiscard]] Result<std::vector<KeyInfo>> createKeys(const std::filesystem::path& folder,
                                                      const std::vector<KeyRequest>& requests,
                                                      const KeySettings& settings = {});

/// Reads the keystore @p folder, but not the private keys of the authorities.
[[nodiscard]] Result<Keystore> readKeystore(const std::filesystem::path& folder,
                                            Time now = std::chrono::system_clock::now());

/// Revokes the certificates of @p name, including retired ones. Writes a revocation list into every
/// identity_ca.cert.pem of the keystore and moves the enclave to retired/. On another machine the revocation
/// takes effect when it has the new identity_ca.cert.pem and the program there is restarted. Returns the
/// number of certificates that were revoked by this call; error when there is none.
[[nodiscard]] Result<int> revokeKeys(const std::filesystem::path& folder, const std::string& name,
                                     Time now = std::chrono::system_clock::now());

}  // namespace leitstand
