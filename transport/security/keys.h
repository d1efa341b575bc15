#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// What the owner of an identity may do in a secured domain; permissionsXml() spells it out.
enum class KeyRole : std::uint8_t {
    Station,  ///< reads everything, commands every robot, writes the station's own topics
    Robot,    ///< publishes below its own name, reads what is addressed to it
    Viewer,   ///< reads everything, may stop robots and ping them, nothing else
};
[[nodiscard]] std::string toString(KeyRole role);  ///< "station", "robot", "viewer"

/// An identity to be made.
struct KeyRequest {
    KeyRole role = KeyRole::Viewer;
    std::string name;  ///< letters, digits and '_', at most 32; of a robot: its name in topics
    /// DDS topics beyond those of the role that it may publish and read, "rt/scan" or "rt/arm/*": for robots
    /// whose topics do not stand below their name.
    std::vector<std::string> moreTopics;
    bool commandsItself = false;  ///< a robot that publishes its own command topics (navigation on board)
};

/// How identities are made.
struct KeySettings {
    int days = 365;             ///< an identity and its permissions are valid for
    int authorityDays = 3'650;  ///< authorities are valid for; at least as long as identities
    bool renew = false;         ///< replaces identities that exist; the old ones are kept in retired/
    Time now = std::chrono::system_clock::now();  ///< validity begins a day earlier, for clocks that are late
};

/// An identity that a keystore has.
struct KeyInfo {
    KeyRole role = KeyRole::Viewer;
    std::string name;
    std::string serial;              ///< number of its certificate, hexadecimal
    Time validFrom{}, validUntil{};  ///< of its certificate
    std::filesystem::path enclave;   ///< the folder that goes to its machine
    bool revoked = false;
    std::string problem;  ///< why it cannot be used now; empty when all is well
};

/// What stands in a keystore.
struct Keystore {
    std::filesystem::path folder;
    Time authorityValidUntil{};
    std::vector<KeyInfo> identities;    ///< by name
    std::vector<std::string> warnings;  ///< "private/identity_ca.key.pem: readable by others ..."
};

/// Makes @p requests in the keystore @p folder, and the keystore with its two authorities first where there
/// is none. The layout is that of ROS 2 (sros2): public/, private/, enclaves/<name>/; keys are files of mode
/// 0600 and are never overwritten. Identities and permissions have an authority each: were they one, the
/// owner of an identity could sign permissions for himself. All requests are checked before anything is
/// written, and each enclave appears whole or not at all. Errors name the file or the name.
[[nodiscard]] Result<std::vector<KeyInfo>> createKeys(const std::filesystem::path& folder,
                                                      const std::vector<KeyRequest>& requests,
                                                      const KeySettings& settings = {});

/// Tells what stands in the keystore @p folder; private keys are not read.
[[nodiscard]] Result<Keystore> readKeystore(const std::filesystem::path& folder,
                                            Time now = std::chrono::system_clock::now());

/// Withdraws the certificates of @p name, also its retired ones: writes a revocation list into every
/// identity_ca.cert.pem of the keystore and moves the enclave to retired/. It holds for a machine once the
/// new identity_ca.cert.pem is there and its program was started anew. The number of certificates withdrawn.
[[nodiscard]] Result<int> revokeKeys(const std::filesystem::path& folder, const std::string& name,
                                     Time now = std::chrono::system_clock::now());

}  // namespace leitstand
