#include "transport/security/keys.h"

#include <algorithm>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "transport/security/authorities.h"
#include "transport/security/key_files.h"
#include "transport/security/permissions.h"

namespace leitstand {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::hours Day(24);
/// Dates of certificates beyond the year 2200 are typing errors.
constexpr int MaxDays = 36'500;

bool isNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

Result<void> checkName(const std::string& name) {
    const bool fits = !name.empty() && name.size() <= 32 && (name[0] < '0' || name[0] > '9') &&
                      std::all_of(name.begin(), name.end(), isNameCharacter);
    if (fits) return {};
    return Error{fmt::format(
        "name \"{}\": expected letters, digits and _, the first no digit, at most 32 (as in ROS names)",
        name)};
}

Result<void> checkRequest(const KeyRequest& request) {
    if (auto fits = checkName(request.name); !fits) return fits;
    if (request.commandsItself && request.role != KeyRole::Robot) {
        return Error{fmt::format("{}: only a robot can command itself", request.name)};
    }
    for (const std::string& topic : request.moreTopics) {
        const bool printable =
            !topic.empty() && topic.size() <= 255 && std::all_of(topic.begin(), topic.end(), [](char c) {
                return isNameCharacter(c) || c == '/' || c == '*' || c == '?';
            });
        if (!printable) {
            return Error{
                fmt::format("{}: topic \"{}\": expected letters, digits, _, /, * and ?, as in "
                            "rt/scan or rt/arm/*",
                            request.name, topic)};
        }
        if (topic.front() == '/') {
            return Error{
                fmt::format("{}: topic \"{}\": expected the name that DDS uses, rt{} for a topic "
                            "of ROS",
                            request.name, topic, topic)};
        }
    }
    return {};
}

Result<void> checkSettings(const KeySettings& settings) {
    if (settings.days < 1 || settings.days > MaxDays || settings.authorityDays > MaxDays) {
        return Error{fmt::format("days: expected 1 to {}", MaxDays)};
    }
    if (settings.authorityDays < settings.days) {
        return Error{"days: authorities must be valid for at least as long as identities"};
    }
    return {};
}

Result<void> checkRequests(const KeystoreLayout& layout, const std::vector<KeyRequest>& requests,
                           const KeySettings& settings) {
    if (auto fits = checkSettings(settings); !fits) return fits;
    std::set<std::string> names;
    std::error_code none;
    for (const KeyRequest& request : requests) {
        if (auto fits = checkRequest(request); !fits) return fits;
        if (!names.insert(request.name).second) {
            return Error{
                fmt::format("name \"{}\": asked for twice; every identity has its own", request.name)};
        }
        const fs::path enclave = layout.enclave(request.name);
        if (!settings.renew && fs::exists(enclave, none)) {
            return Error{
                fmt::format("{}: is there already, and keys are never overwritten; choose another "
                            "name or renew it (--renew)",
                            enclave.string())};
        }
    }
    return {};
}

struct EnclaveFile {
    const char* name;
    std::string text;
    bool secret = false;
};

Result<void> writeEnclave(const fs::path& folder, const std::vector<EnclaveFile>& files) {
    std::error_code none;
    fs::remove_all(folder, none);  // left by an interrupted run
    if (auto made = makeFolder(folder, true); !made) return made;
    for (const EnclaveFile& file : files) {
        if (auto written = writeNewFile(folder / file.name, file.text, file.secret); !written) {
            fs::remove_all(folder, none);
            return written;
        }
    }
    return {};
}

/// Moves the enclave that is replaced to retired/.
Result<void> retire(const KeystoreLayout& layout, const std::string& name) {
    const auto pem = readKeyFile(layout.enclave(name) / "cert.pem");
    if (!pem) return pem.error();
    const auto certificate = openssl::certificateFrom(*pem);
    if (!certificate) {
        return Error{(layout.enclave(name) / "cert.pem").string() + ": " + certificate.error().text};
    }
    if (auto made = makeFolder(layout.retired(), true); !made) return made;
    return moveTo(layout.enclave(name),
                  layout.retired() / (name + "-" + openssl::serialOf(certificate->get())));
}

Result<KeyInfo> createIdentity(const KeystoreLayout& layout, const Authorities& authorities,
                               const KeyRequest& request, const KeySettings& settings) {
    openssl::CertificateSettings about;
    about.organisation = "leitstand";
    about.unit = toString(request.role);
    about.commonName = request.name;
    about.from = settings.now - Day;
    about.until = settings.now + settings.days * Day;
    const auto key = openssl::makeKey();
    if (!key) return key.error();
    const auto certificate = openssl::makeCertificate(about, key->get(), authorities.identityCa.get(),
                                                      authorities.identityKey.get());
    if (!certificate) return certificate.error();
    const std::string permissions =
        permissionsXml(request, openssl::subjectOf(certificate->get()), about.from, about.until);
    X509* signer = authorities.permissionsCa.get();
    const auto signedPermissions = openssl::signText(permissions, signer, authorities.permissionsKey.get());
    const auto governance = openssl::signText(governanceXml(), signer, authorities.permissionsKey.get());
    if (!signedPermissions || !governance) return Error{"OpenSSL cannot sign the permissions"};

    const fs::path fresh = layout.enclaves() / ("." + request.name + ".new");
    const fs::path enclave = layout.enclave(request.name);
    auto done = writeEnclave(fresh, {{"cert.pem", openssl::pemOf(certificate->get())},
                                     {"key.pem", openssl::pemOf(key->get()), true},
                                     {"identity_ca.cert.pem", authorities.identityCaPem},
                                     {"permissions_ca.cert.pem", openssl::pemOf(signer)},
                                     {"governance.p7s", *governance},
                                     {"permissions.p7s", *signedPermissions},
                                     {"permissions.xml", permissions}});
    std::error_code none;
    if (done && fs::exists(enclave, none)) done = retire(layout, request.name);
    if (done) done = moveTo(fresh, enclave);
    if (!done) return done.error();
    KeyInfo info;
    info.role = request.role;
    info.name = request.name;
    info.serial = openssl::serialOf(certificate->get());
    info.validFrom = openssl::validFrom(certificate->get());
    info.validUntil = openssl::validUntil(certificate->get());
    info.enclave = enclave;
    return info;
}

}  // namespace

std::string toString(KeyRole role) {
    switch (role) {
        case KeyRole::Station:
            return "station";
        case KeyRole::Robot:
            return "robot";
        case KeyRole::Viewer:
            break;
    }
    return "viewer";
}

Result<std::vector<KeyInfo>> createKeys(const fs::path& folder, const std::vector<KeyRequest>& requests,
                                        const KeySettings& settings) {
    const KeystoreLayout layout{folder};
    if (auto fits = checkRequests(layout, requests, settings); !fits) return fits.error();
    const auto authorities = openAuthorities(layout, settings);
    if (!authorities) return authorities.error();
    const Time until = openssl::validUntil(authorities->identityCa.get());
    if (until < settings.now + settings.days * Day) {
        return Error{
            fmt::format("{}: is valid until {} only; expected an authority that outlives its "
                        "identities: ask for fewer days, or make a new keystore",
                        layout.identityCa().string(), dateOf(until))};
    }
    if (auto made = makeFolder(layout.enclaves(), false); !made) return made.error();
    std::vector<KeyInfo> made;
    for (const KeyRequest& request : requests) {
        auto info = createIdentity(layout, *authorities, request, settings);
        if (!info) return info.error();
        made.push_back(std::move(info).value());
    }
    return made;
}

}  // namespace leitstand
