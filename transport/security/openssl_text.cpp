// PEM and S/MIME, the formats of the files.
#include <algorithm>

#include <openssl/bio.h>
#include <openssl/bn.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/pkcs7.h>

#include "transport/security/openssl.h"

namespace leitstand::openssl {
namespace {

struct FreeText {
    void operator()(BIO* bio) const { BIO_free(bio); }
    void operator()(PKCS7* message) const { PKCS7_free(message); }
    void operator()(X509_STORE* store) const { X509_STORE_free(store); }
};
using Bio = std::unique_ptr<BIO, FreeText>;
using Message = std::unique_ptr<PKCS7, FreeText>;

Bio reading(const std::string& text) {
    return Bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

Bio writing() {
    return Bio(BIO_new(BIO_s_mem()));
}

std::string contentOf(const Bio& bio) {
    char* text = nullptr;
    const long length = BIO_get_mem_data(bio.get(), &text);
    return length > 0 ? std::string(text, static_cast<std::size_t>(length)) : std::string();
}

/// Refuses keys with a password, for which OpenSSL would ask on the terminal; they count as unreadable.
int noPassword(char*, int, int, void*) {
    return -1;
}

struct Infos {
    explicit Infos(const std::string& pem)
        : list(PEM_X509_INFO_read_bio(reading(pem).get(), nullptr, &noPassword, nullptr)) {}
    ~Infos() { sk_X509_INFO_pop_free(list, X509_INFO_free); }
    Infos(const Infos&) = delete;
    Infos& operator=(const Infos&) = delete;
    STACK_OF(X509_INFO) * list;
};

}  // namespace

Result<std::string> signText(const std::string& text, X509* certificate, EVP_PKEY* key) {
    constexpr int Form = PKCS7_DETACHED | PKCS7_TEXT;
    const Bio in = reading(text);
    const Message message(PKCS7_sign(certificate, key, nullptr, in.get(), Form));
    const Bio again = reading(text), out = writing();
    if (message == nullptr || SMIME_write_PKCS7(out.get(), message.get(), again.get(), Form) != 1) {
        ERR_clear_error();
        return Error{"OpenSSL cannot sign a text"};
    }
    return contentOf(out);
}

Result<std::string> verifiedText(const std::string& smime, X509* authority) {
    const Bio in = reading(smime), out = writing();
    BIO* found = nullptr;
    const Message message(SMIME_read_PKCS7(in.get(), &found));
    const Bio content(found);
    const std::unique_ptr<X509_STORE, FreeText> store(X509_STORE_new());
    // Another check, with a clearer error, covers whether the authority is still valid.
    const bool verified =
        message != nullptr && X509_STORE_add_cert(store.get(), authority) == 1 &&
        X509_STORE_set_flags(store.get(), X509_V_FLAG_NO_CHECK_TIME) == 1 &&
        PKCS7_verify(message.get(), nullptr, store.get(), content.get(), out.get(), PKCS7_TEXT) == 1;
    ERR_clear_error();
    if (message == nullptr) return Error{"expected a text signed as S/MIME"};
    if (!verified) return Error{"expected the permissions authority's signature"};
    return contentOf(out);
}

std::string pemOf(EVP_PKEY* key) {
    const Bio out = writing();
    PEM_write_bio_PrivateKey(out.get(), key, nullptr, nullptr, 0, nullptr, nullptr);
    return contentOf(out);
}

std::string pemOf(X509* certificate) {
    const Bio out = writing();
    PEM_write_bio_X509(out.get(), certificate);
    return contentOf(out);
}

std::string pemOf(X509_CRL* list) {
    const Bio out = writing();
    PEM_write_bio_X509_CRL(out.get(), list);
    return contentOf(out);
}

Result<Certificate> certificateFrom(const std::string& pem) {
    Certificate certificate(PEM_read_bio_X509(reading(pem).get(), nullptr, &noPassword, nullptr));
    ERR_clear_error();
    if (certificate == nullptr) return Error{"expected a certificate (PEM)"};
    return certificate;
}

Result<Key> keyFrom(const std::string& pem) {
    Key key(PEM_read_bio_PrivateKey(reading(pem).get(), nullptr, &noPassword, nullptr));
    ERR_clear_error();
    if (key == nullptr) return Error{"expected a private key (PEM, without a password)"};
    return key;
}

Result<std::vector<std::string>> revokedIn(const std::string& pem, X509* authority) {
    const Infos infos(pem);
    ERR_clear_error();
    std::vector<std::string> serials;
    for (int i = 0; i < sk_X509_INFO_num(infos.list); ++i) {
        X509_CRL* list = sk_X509_INFO_value(infos.list, i)->crl;
        if (list == nullptr) continue;
        if (X509_CRL_verify(list, X509_get0_pubkey(authority)) != 1) {
            ERR_clear_error();
            return Error{"expected the identity authority's signature on the revocation list"};
        }
        const STACK_OF(X509_REVOKED)* entries = X509_CRL_get_REVOKED(list);
        for (int k = 0; k < sk_X509_REVOKED_num(entries); ++k) {
            const ASN1_INTEGER* serial = X509_REVOKED_get0_serialNumber(sk_X509_REVOKED_value(entries, k));
            BIGNUM* number = ASN1_INTEGER_to_BN(serial, nullptr);
            char* hex = BN_bn2hex(number);
            if (hex != nullptr) serials.emplace_back(hex);
            OPENSSL_free(hex);
            BN_free(number);
        }
    }
    std::sort(serials.begin(), serials.end());
    serials.erase(std::unique(serials.begin(), serials.end()), serials.end());
    return serials;
}

}  // namespace leitstand::openssl
