#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <openssl/evp.h>
#include <openssl/x509.h>

#include "core/base/result.h"
#include "core/base/time.h"

/// What identities need of OpenSSL, with owners and errors in words.
namespace leitstand::openssl {

struct Free {
    void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
    void operator()(X509* certificate) const { X509_free(certificate); }
    void operator()(X509_CRL* list) const { X509_CRL_free(list); }
};
using Key = std::unique_ptr<EVP_PKEY, Free>;
using Certificate = std::unique_ptr<X509, Free>;
using RevocationList = std::unique_ptr<X509_CRL, Free>;

/// What is particular about a certificate; its keys are of the curve P-256, it is signed with SHA-256.
struct CertificateSettings {
    std::string organisation, unit, commonName;  ///< ASCII; together "CN=...,OU=...,O=..."
    Time from{}, until{};
    bool authority = false;  ///< it may sign certificates, revocation lists and messages
};

[[nodiscard]] Result<Key> makeKey();
/// A certificate of @p key, signed by @p authorityKey; of itself when there is no @p authority.
[[nodiscard]] Result<Certificate> makeCertificate(const CertificateSettings& settings, EVP_PKEY* key,
                                                  X509* authority, EVP_PKEY* authorityKey);
/// @p text signed by @p certificate, in the S/MIME form (detached, text/plain) that DDS-Security asks for.
[[nodiscard]] Result<std::string> signText(const std::string& text, X509* certificate, EVP_PKEY* key);
/// The text of @p smime, when @p authority signed it.
[[nodiscard]] Result<std::string> verifiedText(const std::string& smime, X509* authority);
/// All serial numbers of @p revoked withdrawn, signed by @p authority.
[[nodiscard]] Result<RevocationList> makeRevocationList(const std::vector<std::string>& revoked, Time now,
                                                        X509* authority, EVP_PKEY* authorityKey);

[[nodiscard]] std::string pemOf(EVP_PKEY* key);
[[nodiscard]] std::string pemOf(X509* certificate);
[[nodiscard]] std::string pemOf(X509_CRL* list);
/// The first certificate in @p pem; an error text without a file name.
[[nodiscard]] Result<Certificate> certificateFrom(const std::string& pem);
[[nodiscard]] Result<Key> keyFrom(const std::string& pem);
/// Serial numbers that the revocation lists in @p pem withdraw; lists that @p authority did not sign are an
/// error.
[[nodiscard]] Result<std::vector<std::string>> revokedIn(const std::string& pem, X509* authority);

[[nodiscard]] std::string subjectOf(const X509* certificate);  ///< in the order of RFC 2253
/// "CN", "OU" or "O" of the subject; empty when absent.
[[nodiscard]] std::string subjectPart(const X509* certificate, const char* part);
[[nodiscard]] std::string serialOf(const X509* certificate);  ///< hexadecimal
[[nodiscard]] Time validFrom(const X509* certificate);
[[nodiscard]] Time validUntil(const X509* certificate);
[[nodiscard]] bool signedBy(X509* certificate, X509* authority);

}  // namespace leitstand::openssl
