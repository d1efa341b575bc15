#pragma once

#include <string>

#include "core/base/result.h"
#include "transport/security/key_files.h"
#include "transport/security/keys.h"
#include "transport/security/openssl.h"

namespace leitstand {

/// The two authorities of a keystore with their private keys.
struct Authorities {
    openssl::Certificate identityCa, permissionsCa;
    openssl::Key identityKey, permissionsKey;
    std::string identityCaPem;  ///< the certificate, and the revocation list if there is one
};

/// Opens the authorities of @p layout. Makes them when the folder is empty or missing.
[[nodiscard]] Result<Authorities> openAuthorities(const KeystoreLayout& layout, const KeySettings& settings);
/// Opens the authorities of @p layout. Error when they are missing.
[[nodiscard]] Result<Authorities> readAuthorities(const KeystoreLayout& layout);

}  // namespace leitstand
