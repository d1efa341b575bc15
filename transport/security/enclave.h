#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "transport/dds/node_settings.h"

namespace leitstand {

/// The files of the enclave @p folder ("KEYS/enclaves/station1"), after a check that DDS does only silently:
/// all are there and not readable by others (the key), the certificate is by the identity authority, neither
/// expired nor revoked, the key fits, governance and permissions are signed by the permissions authority and
/// speak of this certificate's subject. Errors name the file and what to do.
[[nodiscard]] Result<SecurityFiles> securityFiles(const std::filesystem::path& folder,
                                                  Time now = std::chrono::system_clock::now());

/// One line that tells the operator whether the domain is secured: "Security is OFF: ..." or
/// "Security is on: station1 (station), valid until 2027-01-31".
[[nodiscard]] std::string securityLine(const std::optional<SecurityFiles>& files);

}  // namespace leitstand
