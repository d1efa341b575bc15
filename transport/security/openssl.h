#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <openssl/evp.h>
#include <openssl/x509.h>

#include "core/base/result.h"
#include "core/base/time.h"

/// The functions of OpenSSL that identities need, with owning types and readable errors.
namespace leitstand::openssl {

struct Free {
    void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
    void operator()(X509* certificate) const { X509_free(certificate); }
    void operator()(X509_CRL* list) const { X509_CRL_free(list); }
};
using Key = std::unique_ptr<EVP_PKEY, Free>;
using Certificate = std::unique_ptr<X509, Free>;
using RevocationList = std::unique_ptr<X509_CRL, Free>;

/// Contents of a certificate. Keys are on the curve P-256; certificates are signed with SHA-256.
struct CertificateSettings {
    std::string organisation, unit, commonName;  ///< ASCII; the subject is "CN=...,OU=...,O=..."
    Time from{}, until{};
    bool authority = false;  ///< whether it may sign certificates, revocation lists and messages
};

[[nodiscard]] Result<Key> makeKey();
/// Makes a certificate for @p key, signed with @p authorityKey. It is self-signed if there is no
/// @p authority.
[[nodiscard]] Result<Certificate> makeCertificate(const CertificateSettings& settings, EVP_PKEY* key,
                                                  X509* authority, EVP_PKEY* authorityKey);
/// Returns @p text signed with @p certificate, in the S/MIME form of DDS-Security (detached, text/plain).
[[nodiscard]] Result<std::string> signText(const std::string& text, X509* certificate, EVP_PKEY* key);
/// Returns the text of @p smime. Error when @p authority did not sign it.
[[nodiscard]] Result<std::string> verifiedText(const std::string& smime, X509* authority);
/// Makes a list that revokes all serial numbers in @p revoked, signed by @p authority.
[[nodiscard]] Result<RevocationList> makeRevocationList(const std::vector<std::string>& revoked, Time now,
                                                        X509* authority, EVP_PKEY* authorityKey);

[[nodiscard]] std::string pemOf(EVP_PKEY* key);
[[nodiscard]] std::string pemOf(X509* certificate);
[[nodiscard]] std::string pemOf(X509_CRL* list);
/// Returns the first certificate in @p pem. The error has no file name.
[[nodiscard]] Result<Certificate> certificateFrom(const std::string& pem);
[[nodiscard]] Result<Key> keyFrom(const std::string& pem);
/// Returns the serial numbers in the revocation lists of @p pem: hexadecimal, sorted. Error when @p authority
/// did not sign a list.
[[nodiscard]] Result<std::vector<std::string>> revokedIn(const std::string& pem, X509* authority);

[[nodiscard]] std::string subjectOf(const X509* certificate);  ///< its parts are in the order of RFC 2253
/// Returns "CN", "OU" or "O" of the subject; empty: it has none.
[[nodiscard]] std::string subjectPart(const X509* certificate, const char* part);
[[nodiscard]] std::string serialOf(const X509* certificate);  ///< hexadecimal
[[nodiscard]] Time validFrom(const X509* certificate);
[[nodiscard]] Time validUntil(const X509* certificate);
[[nodiscard]] bool signedBy(X509* certificate, X509* authority);

}  // namespace leitstand::openssl
