#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "transport/dds/node_settings.h"

namespace leitstand {

/// Returns the files of the enclave @p folder ("KEYS/enclaves/station1"), after checks that DDS makes only
/// silently. All files exist, and others cannot read the key. The certificate is signed by the identity
/// authority and neither expired nor revoked; the key fits it. Governance and permissions are signed by the
/// permissions authority, and the permissions are for this certificate's subject. Errors name the file and
/// what to do.
[[nodiscard]] Result<SecurityFiles> securityFiles(const std::filesystem::path& folder,
                                                  Time now = std::chrono::system_clock::now());

/// Returns one line for the operator on whether the domain is secured: "Security is OFF: ..." or "Security is
/// on: station1 (station), valid until 2027-01-31".
[[nodiscard]] std::string securityLine(const std::optional<SecurityFiles>& files);

}  // namespace leitstand
