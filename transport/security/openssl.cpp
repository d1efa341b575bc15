#include "transport/security/openssl.h"

#include <ctime>

#include <fmt/format.h>
#include <openssl/bn.h>
#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

namespace leitstand::openssl {
namespace {

Error failure(const char* what) {
    std::string reason = "unknown reason";
    if (const unsigned long code = ERR_peek_last_error(); code != 0) {
        char text[256];
        ERR_error_string_n(code, text, sizeof text);
        reason = text;
    }
    ERR_clear_error();
    return Error{fmt::format("OpenSSL cannot {}: {}", what, reason)};
}

std::time_t seconds(Time time) {
    return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
}

Time timeOf(const ASN1_TIME* time) {
    std::tm utc{};
    if (ASN1_TIME_to_tm(time, &utc) != 1) return {};
    return Time(std::chrono::seconds(timegm(&utc)));
}

bool addPart(X509_NAME* name, const char* part, const std::string& text) {
    return text.empty() ||
           X509_NAME_add_entry_by_txt(name, part, MBSTRING_ASC,
                                      reinterpret_cast<const unsigned char*>(text.c_str()), -1, -1, 0) == 1;
}

/// Sets a random positive number of 16 bytes, so that no two certificates of one authority share theirs.
bool setSerial(X509* certificate) {
    unsigned char bytes[16];
    if (RAND_bytes(bytes, sizeof bytes) != 1) return false;
    bytes[0] = static_cast<unsigned char>((bytes[0] & 0x7f) | 0x40);
    const std::unique_ptr<BIGNUM, decltype(&BN_free)> number(BN_bin2bn(bytes, sizeof bytes, nullptr),
                                                             &BN_free);
    return number != nullptr &&
           BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate)) != nullptr;
}

bool addExtension(X509* certificate, X509* authority, int nid, const char* value) {
    X509V3_CTX context;
    X509V3_set_ctx_nodb(&context);
    X509V3_set_ctx(&context, authority, certificate, nullptr, nullptr, 0);
    X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, &context, nid, value);
    if (extension == nullptr) return false;
    const bool added = X509_add_ext(certificate, extension, -1) == 1;
    X509_EXTENSION_free(extension);
    return added;
}

bool addExtensions(X509* certificate, X509* authority, bool isAuthority) {
    // An authority signs permissions as messages, hence digitalSignature.
    const char* uses = isAuthority ? "critical,keyCertSign,cRLSign,digitalSignature"
                                   : "critical,digitalSignature,keyAgreement";
    return addExtension(certificate, authority, NID_basic_constraints,
                        isAuthority ? "critical,CA:TRUE,pathlen:0" : "critical,CA:FALSE") &&
           addExtension(certificate, authority, NID_key_usage, uses) &&
           addExtension(certificate, authority, NID_subject_key_identifier, "hash") &&
           addExtension(certificate, authority, NID_authority_key_identifier, "keyid:always");
}

}  // namespace

Result<Key> makeKey() {
    Key key(EVP_EC_gen("P-256"));
    if (key == nullptr) return failure("make a key");
    return key;
}

Result<Certificate> makeCertificate(const CertificateSettings& settings, EVP_PKEY* key, X509* authority,
                                    EVP_PKEY* authorityKey) {
    Certificate certificate(X509_new());
    X509* made = certificate.get();
    X509_NAME* name = made == nullptr ? nullptr : X509_get_subject_name(made);
    if (name == nullptr) return failure("make a certificate");
    X509* issuer = authority == nullptr ? made : authority;
    const bool done = X509_set_version(made, X509_VERSION_3) == 1 && setSerial(made) &&
                      addPart(name, "O", settings.organisation) && addPart(name, "OU", settings.unit) &&
                      addPart(name, "CN", settings.commonName) &&
                      X509_set_issuer_name(made, X509_get_subject_name(issuer)) == 1 &&
                      ASN1_TIME_set(X509_getm_notBefore(made), seconds(settings.from)) != nullptr &&
                      ASN1_TIME_set(X509_getm_notAfter(made), seconds(settings.until)) != nullptr &&
                      X509_set_pubkey(made, key) == 1 && addExtensions(made, issuer, settings.authority) &&
                      X509_sign(made, authorityKey, EVP_sha256()) > 0;
    if (!done) return failure("make a certificate");
    return certificate;
}

Result<RevocationList> makeRevocationList(const std::vector<std::string>& revoked, Time now, X509* authority,
                                          EVP_PKEY* authorityKey) {
    RevocationList list(X509_CRL_new());
    const std::unique_ptr<ASN1_TIME, decltype(&ASN1_TIME_free)> time(ASN1_TIME_set(nullptr, seconds(now)),
                                                                     &ASN1_TIME_free);
    // Without a next update the list never expires: a station without a network must not lose its robots.
    bool done = list != nullptr && time != nullptr &&
                X509_CRL_set_version(list.get(), X509_CRL_VERSION_2) == 1 &&
                X509_CRL_set_issuer_name(list.get(), X509_get_subject_name(authority)) == 1 &&
                X509_CRL_set1_lastUpdate(list.get(), time.get()) == 1;
    for (const std::string& serial : revoked) {
        if (!done) break;
        BIGNUM* number = nullptr;
        X509_REVOKED* entry = X509_REVOKED_new();
        done = entry != nullptr && BN_hex2bn(&number, serial.c_str()) > 0;
        ASN1_INTEGER* integer = done ? BN_to_ASN1_INTEGER(number, nullptr) : nullptr;
        done = integer != nullptr && X509_REVOKED_set_serialNumber(entry, integer) == 1 &&
               X509_REVOKED_set_revocationDate(entry, time.get()) == 1 &&
               X509_CRL_add0_revoked(list.get(), entry) == 1;
        if (!done) X509_REVOKED_free(entry);
        ASN1_INTEGER_free(integer);
        BN_free(number);
    }
    done =
        done && X509_CRL_sort(list.get()) == 1 && X509_CRL_sign(list.get(), authorityKey, EVP_sha256()) > 0;
    if (!done) return failure("make a revocation list");
    return list;
}

std::string subjectOf(const X509* certificate) {
    const std::unique_ptr<BIO, decltype(&BIO_free)> out(BIO_new(BIO_s_mem()), &BIO_free);
    X509_NAME_print_ex(out.get(), X509_get_subject_name(certificate), 0, XN_FLAG_RFC2253);
    char* text = nullptr;
    const long length = BIO_get_mem_data(out.get(), &text);
    return {text, static_cast<std::size_t>(length)};
}

std::string subjectPart(const X509* certificate, const char* part) {
    X509_NAME* name = X509_get_subject_name(certificate);
    const int place = X509_NAME_get_index_by_NID(name, OBJ_sn2nid(part), -1);
    if (place < 0) return {};
    const ASN1_STRING* text = X509_NAME_ENTRY_get_data(X509_NAME_get_entry(name, place));
    return {reinterpret_cast<const char*>(ASN1_STRING_get0_data(text)),
            static_cast<std::size_t>(ASN1_STRING_length(text))};
}

std::string serialOf(const X509* certificate) {
    const std::unique_ptr<BIGNUM, decltype(&BN_free)> number(
        ASN1_INTEGER_to_BN(X509_get0_serialNumber(certificate), nullptr), &BN_free);
    char* hex = BN_bn2hex(number.get());
    const std::string text = hex == nullptr ? "" : hex;
    OPENSSL_free(hex);
    return text;
}

Time validFrom(const X509* certificate) {
    return timeOf(X509_get0_notBefore(certificate));
}

Time validUntil(const X509* certificate) {
    return timeOf(X509_get0_notAfter(certificate));
}

bool signedBy(X509* certificate, X509* authority) {
    const bool fits = X509_check_issued(authority, certificate) == X509_V_OK &&
                      X509_verify(certificate, X509_get0_pubkey(authority)) == 1;
    ERR_clear_error();
    return fits;
}

}  // namespace leitstand::openssl
