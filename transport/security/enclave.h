#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "transport/dds/node_settings.h"

namespace leitstand {

/// Returns the files of the enclave @p folder ("KEYS/enclaves/station1") after checking what DDS would not
/// explain. All files must exist, and others must not be able to read the key. The certificate must be signed
/// by the identity authority, fit the key, and be neither expired nor revoked. Governance and permissions
/// must be signed by the permissions authority, and the permissions must be for the certificate's subject.
/// Errors name the file and what to do.
[[nodiscard]] Result<SecurityFiles> securityFiles(const std::filesystem::path& folder,
                                                  Time now = std::chrono::system_clock::now());

/// Returns one line for the operator that says whether the domain is secured: "Security is OFF: ..." or
/// "Security is on: station1 (station), valid until 2027-01-31".
[[nodiscard]] std::string securityLine(const std::optional<SecurityFiles>& files);

}  // namespace leitstand
