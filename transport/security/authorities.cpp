#include "transport/security/authorities.h"

#include <system_error>

#include <fmt/format.h>
#include <openssl/rand.h>

namespace leitstand {
namespace fs = std::filesystem;
namespace {

/// Returns a name unlike those in other keystores, since DDS compares authorities by their names.
std::string uniqueName(const char* what) {
    unsigned char bytes[4] = {};
    if (RAND_bytes(bytes, sizeof bytes) != 1) return what;
    return fmt::format("{} {:02x}{:02x}{:02x}{:02x}", what, bytes[0], bytes[1], bytes[2], bytes[3]);
}

Result<void> makeAuthority(const char* name, const fs::path& certificateFile, const fs::path& keyFile,
                           const KeySettings& settings) {
    openssl::CertificateSettings about;
    about.organisation = "leitstand";
    about.commonName = uniqueName(name);
    about.from = settings.now - std::chrono::hours(24);
    about.until = settings.now + std::chrono::hours(24) * settings.authorityDays;
    about.authority = true;
    const auto key = openssl::makeKey();
    if (!key) return key.error();
    const auto certificate = openssl::makeCertificate(about, key->get(), nullptr, key->get());
    if (!certificate) return certificate.error();
    if (auto written = writeNewFile(keyFile, openssl::pemOf(key->get()), true); !written) return written;
    return writeNewFile(certificateFile, openssl::pemOf(certificate->get()), false);
}

Result<openssl::Certificate> readCertificate(const fs::path& file) {
    const auto pem = readKeyFile(file);
    if (!pem) return pem.error();
    auto certificate = openssl::certificateFrom(*pem);
    if (!certificate) return Error{file.string() + ": " + certificate.error().text};
    return certificate;
}

Result<openssl::Key> readKey(const fs::path& file, const X509* certificate) {
    const auto pem = readKeyFile(file);
    if (!pem) return pem.error();
    auto key = openssl::keyFrom(*pem);
    if (!key) return Error{file.string() + ": " + key.error().text};
    if (X509_check_private_key(certificate, key->get()) != 1) {
        return Error{file.string() + ": expected the key of the certificate in public/"};
    }
    return key;
}

}  // namespace

Result<Authorities> readAuthorities(const KeystoreLayout& layout) {
    auto identityCa = readCertificate(layout.identityCa());
    if (!identityCa) return identityCa.error();
    auto permissionsCa = readCertificate(layout.permissionsCa());
    if (!permissionsCa) return permissionsCa.error();
    auto identityKey = readKey(layout.identityCaKey(), identityCa->get());
    if (!identityKey) return identityKey.error();
    auto permissionsKey = readKey(layout.permissionsCaKey(), permissionsCa->get());
    if (!permissionsKey) return permissionsKey.error();
    auto pem = readKeyFile(layout.identityCa());
    if (!pem) return pem.error();
    if (X509_cmp(identityCa->get(), permissionsCa->get()) == 0) {
        return Error{
            fmt::format("{}: expected an authority of its own for permissions; with one for both, as "
                        "sros2 makes it, the owner of an identity could sign permissions for himself",
                        layout.permissionsCa().string())};
    }
    Authorities authorities;
    authorities.identityCa = std::move(identityCa).value();
    authorities.permissionsCa = std::move(permissionsCa).value();
    authorities.identityKey = std::move(identityKey).value();
    authorities.permissionsKey = std::move(permissionsKey).value();
    authorities.identityCaPem = std::move(pem).value();
    return authorities;
}

Result<Authorities> openAuthorities(const KeystoreLayout& layout, const KeySettings& settings) {
    std::error_code problem;
    const bool there = fs::exists(layout.identityCa(), problem);
    if (!there) {
        if (fs::exists(layout.folder, problem) && !fs::is_empty(layout.folder, problem)) {
            return Error{
                fmt::format("{}: expected a keystore (public/identity_ca.cert.pem), an empty folder "
                            "or none",
                            layout.folder.string())};
        }
        for (const auto& [folder, secret] : {std::pair(layout.identityCa().parent_path(), false),
                                             std::pair(layout.identityCaKey().parent_path(), true)}) {
            if (auto made = makeFolder(folder, secret); !made) return made.error();
        }
        // The identity authority's certificate, which identifies a keystore, comes last.
        auto made = makeAuthority("Leitstand permissions", layout.permissionsCa(), layout.permissionsCaKey(),
                                  settings);
        if (made) {
            made =
                makeAuthority("Leitstand identities", layout.identityCa(), layout.identityCaKey(), settings);
        }
        if (!made) return made.error();
    }
    return readAuthorities(layout);
}

}  // namespace leitstand
