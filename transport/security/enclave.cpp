#include "transport/security/enclave.h"

#include <algorithm>

#include <fmt/format.h>

#include "transport/security/key_files.h"
#include "transport/security/openssl.h"
#include "transport/security/permissions.h"

namespace leitstand {
namespace fs = std::filesystem;
namespace {

Error at(const fs::path& file, const std::string& text) {
    return Error{file.string() + ": " + text};
}

Result<openssl::Certificate> readCertificate(const fs::path& file) {
    const auto pem = readKeyFile(file);
    if (!pem) return pem.error();
    auto certificate = openssl::certificateFrom(*pem);
    if (!certificate) return at(file, certificate.error().text);
    return certificate;
}

Result<void> checkTime(const fs::path& file, const X509* certificate, Time now) {
    if (openssl::validUntil(certificate) < now) {
        return at(file,
                  fmt::format("expired on {}; make a new one with leitstandctl keys --renew, or set this "
                              "computer's clock (it is {})",
                              dateOf(openssl::validUntil(certificate)), dateOf(now)));
    }
    if (openssl::validFrom(certificate) > now) {
        return at(file, fmt::format("is valid from {} on; set this computer's clock (it is {})",
                                    dateOf(openssl::validFrom(certificate)), dateOf(now)));
    }
    return {};
}

Result<void> checkIdentity(const SecurityFiles& files, Time now) {
    const auto certificate = readCertificate(files.certificate);
    if (!certificate) return certificate.error();
    const auto authority = readCertificate(files.identityCa);
    if (!authority) return authority.error();
    if (!openssl::signedBy(certificate->get(), authority->get())) {
        return at(files.certificate,
                  "expected a certificate by the authority in identity_ca.cert.pem; these "
                  "files are of different keystores");
    }
    for (const auto& [file, checked] :
         {std::pair(files.certificate, certificate->get()), std::pair(files.identityCa, authority->get())}) {
        if (auto fits = checkTime(file, checked, now); !fits) return fits;
    }
    const auto pem = readKeyFile(files.identityCa);
    if (!pem) return pem.error();
    const auto revoked = openssl::revokedIn(*pem, authority->get());
    if (!revoked) return at(files.identityCa, revoked.error().text);
    if (std::binary_search(revoked->begin(), revoked->end(), openssl::serialOf(certificate->get()))) {
        return at(files.certificate, "is revoked; ask the keeper of the keys for a new identity");
    }
    if (const std::string problem = accessProblem(files.privateKey); !problem.empty()) return Error{problem};
    const auto keyPem = readKeyFile(files.privateKey);
    if (!keyPem) return keyPem.error();
    const auto key = openssl::keyFrom(*keyPem);
    if (!key) return at(files.privateKey, key.error().text);
    if (X509_check_private_key(certificate->get(), key->get()) != 1) {
        return at(files.privateKey, "expected the key of cert.pem");
    }
    return {};
}

Result<void> checkPermissions(const SecurityFiles& files, Time now) {
    const auto authority = readCertificate(files.permissionsCa);
    if (!authority) return authority.error();
    if (auto fits = checkTime(files.permissionsCa, authority->get(), now); !fits) return fits;
    const auto certificate = readCertificate(files.certificate);
    if (!certificate) return certificate.error();
    for (const fs::path& file : {files.governance, files.permissions}) {
        const auto smime = readKeyFile(file);
        if (!smime) return smime.error();
        const auto text = openssl::verifiedText(*smime, authority->get());
        if (!text) return at(file, text.error().text);
        const std::string subject = openssl::subjectOf(certificate->get());
        if (file == files.permissions && text->find(xmlEscaped(subject)) == std::string::npos) {
            return at(file, "expected permissions for " + subject + ", the owner of cert.pem");
        }
    }
    return {};
}

}  // namespace

Result<SecurityFiles> securityFiles(const fs::path& folder, Time now) {
    SecurityFiles files;
    files.identityCa = folder / "identity_ca.cert.pem";
    files.certificate = folder / "cert.pem";
    files.privateKey = folder / "key.pem";
    files.permissionsCa = folder / "permissions_ca.cert.pem";
    files.governance = folder / "governance.p7s";
    files.permissions = folder / "permissions.p7s";
    if (auto fits = checkIdentity(files, now); !fits) return fits.error();
    if (auto fits = checkPermissions(files, now); !fits) return fits.error();
    return files;
}

std::string securityLine(const std::optional<SecurityFiles>& files) {
    if (!files) return "Security is OFF: anyone in this network can read and command the robots";
    const auto certificate = readCertificate(files->certificate);
    if (!certificate) return "Security is on, but " + certificate.error().text;
    std::string role = openssl::subjectPart(certificate->get(), "OU");
    if (!role.empty()) role = " (" + role + ")";
    return fmt::format("Security is on: {}{}, valid until {}", openssl::subjectPart(certificate->get(), "CN"),
                       role, dateOf(openssl::validUntil(certificate->get())));
}

}  // namespace leitstand
