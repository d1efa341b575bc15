// Reads a keystore, and revokes certificates that it issued.
#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "transport/security/authorities.h"
#include "transport/security/enclave.h"
#include "transport/security/key_files.h"
#include "transport/security/keys.h"

namespace leitstand {
namespace fs = std::filesystem;
namespace {

KeyRole roleOf(const X509* certificate) {
    const std::string unit = openssl::subjectPart(certificate, "OU");
    if (unit == toString(KeyRole::Station)) return KeyRole::Station;
    if (unit == toString(KeyRole::Robot)) return KeyRole::Robot;
    return KeyRole::Viewer;
}

std::vector<fs::path> foldersIn(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        const bool hidden = entry->path().filename().string().starts_with('.');
        if (!hidden && entry->is_directory(problem)) found.push_back(entry->path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

Result<openssl::Certificate> certificateIn(const fs::path& enclave) {
    const fs::path file = enclave / "cert.pem";
    const auto pem = readKeyFile(file);
    if (!pem) return pem.error();
    auto certificate = openssl::certificateFrom(*pem);
    if (!certificate) return Error{file.string() + ": " + certificate.error().text};
    return certificate;
}

KeyInfo describe(const fs::path& enclave, Time now) {
    KeyInfo info;
    info.enclave = enclave;
    info.name = enclave.filename().string();
    const auto certificate = certificateIn(enclave);
    if (!certificate) {
        info.problem = certificate.error().text;
        return info;
    }
    info.role = roleOf(certificate->get());
    info.serial = openssl::serialOf(certificate->get());
    info.validFrom = openssl::validFrom(certificate->get());
    info.validUntil = openssl::validUntil(certificate->get());
    if (const auto files = securityFiles(enclave, now); !files) info.problem = files.error().text;
    return info;
}

bool contains(const std::vector<std::string>& list, const std::string& text) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

/// Returns the certificate in @p pem without the revocation lists behind it.
std::string withoutLists(const std::string& pem) {
    return pem.substr(0, pem.find("-----BEGIN X509 CRL-----"));
}

}  // namespace

Result<Keystore> readKeystore(const fs::path& folder, Time now) {
    const KeystoreLayout layout{folder};
    const auto pem = readKeyFile(layout.identityCa());
    if (!pem) return Error{pem.error().text + "; expected a keystore of leitstandctl keys"};
    const auto authority = openssl::certificateFrom(*pem);
    if (!authority) return Error{layout.identityCa().string() + ": " + authority.error().text};
    const auto revoked = openssl::revokedIn(*pem, authority->get());
    if (!revoked) return Error{layout.identityCa().string() + ": " + revoked.error().text};
    Keystore keystore;
    keystore.folder = folder;
    keystore.authorityValidUntil = openssl::validUntil(authority->get());
    for (const fs::path& enclave : foldersIn(layout.enclaves())) {
        keystore.identities.push_back(describe(enclave, now));
    }
    for (const fs::path& enclave : foldersIn(layout.retired())) {
        KeyInfo info = describe(enclave, now);
        if (!contains(*revoked, info.serial)) continue;
        info.revoked = true;
        info.problem = "revoked";
        info.name = info.name.substr(0, info.name.rfind('-'));
        keystore.identities.push_back(std::move(info));
    }
    std::stable_sort(keystore.identities.begin(), keystore.identities.end(),
                     [](const KeyInfo& a, const KeyInfo& b) { return a.name < b.name; });
    for (const fs::path& key : {layout.identityCaKey(), layout.permissionsCaKey()}) {
        if (const std::string problem = accessProblem(key); !problem.empty()) {
            keystore.warnings.push_back(problem);
        }
    }
    return keystore;
}

Result<int> revokeKeys(const fs::path& folder, const std::string& name, Time now) {
    const KeystoreLayout layout{folder};
    const auto authorities = readAuthorities(layout);
    if (!authorities) return authorities.error();
    X509* authority = authorities->identityCa.get();
    const auto before = openssl::revokedIn(authorities->identityCaPem, authority);
    if (!before) return Error{layout.identityCa().string() + ": " + before.error().text};

    std::vector<std::string> revoked = *before;
    std::string current;
    std::error_code none;
    std::vector<fs::path> enclaves = foldersIn(layout.retired());
    enclaves.push_back(layout.enclave(name));
    for (const fs::path& enclave : enclaves) {
        const auto certificate = certificateIn(enclave);
        if (!certificate || openssl::subjectPart(certificate->get(), "CN") != name) continue;
        const std::string serial = openssl::serialOf(certificate->get());
        if (enclave == layout.enclave(name)) current = serial;
        if (!contains(revoked, serial)) revoked.push_back(serial);
    }
    const int added = static_cast<int>(revoked.size() - before->size());
    if (added == 0) {
        return Error{
            fmt::format("{}: no certificate that could be revoked; expected one of the names that "
                        "leitstandctl keys show {} lists",
                        layout.enclave(name).string(), folder.string())};
    }
    const auto list = openssl::makeRevocationList(revoked, now, authority, authorities->identityKey.get());
    if (!list) return list.error();
    const std::string pem = withoutLists(authorities->identityCaPem) + openssl::pemOf(list->get());
    if (auto done = replaceFile(layout.identityCa(), pem); !done) return done.error();
    if (!current.empty()) {
        auto done = makeFolder(layout.retired(), true);
        if (done) done = moveTo(layout.enclave(name), layout.retired() / (name + "-" + current));
        if (!done) return done.error();
    }
    for (const fs::path& enclave : foldersIn(layout.enclaves())) {
        if (auto done = replaceFile(enclave / "identity_ca.cert.pem", pem); !done) return done.error();
    }
    return added;
}

}  // namespace leitstand
