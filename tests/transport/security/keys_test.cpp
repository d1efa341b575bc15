#include "transport/security/keys.h"

#include <filesystem>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/temporary_folder.h"
#include "transport/security/enclave.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

const std::vector<KeyRequest> Team = {{KeyRole::Station, "station1", {}, false},
                                      {KeyRole::Robot, "kurt3d", {}, false},
                                      {KeyRole::Viewer, "coach", {}, false}};

std::string complaintOf(const Result<std::vector<KeyInfo>>& result) {
    return result.ok() ? std::string() : result.error().text;
}

std::string complaintOf(const Result<SecurityFiles>& result) {
    return result.ok() ? std::string() : result.error().text;
}

mode_t modeOf(const fs::path& file) {
    struct stat about {};
    EXPECT_EQ(stat(file.c_str(), &about), 0) << file;
    return about.st_mode & 0777;
}

class Keys : public ::testing::Test {
protected:
    Result<std::vector<KeyInfo>> create(const std::vector<KeyRequest>& requests,
                                        const KeySettings& settings = {}) {
        return createKeys(m_store, requests, settings);
    }
    [[nodiscard]] fs::path enclave(const std::string& name) const { return m_store / "enclaves" / name; }

    const TemporaryFolder m_folder;
    const fs::path m_store = m_folder / "keys";
};

TEST_F(Keys, MakeAKeystoreAsRos2LaysItOut) {
    const auto made = create(Team);
    ASSERT_TRUE(made.ok()) << made.error().text;
    ASSERT_THAT(*made, SizeIs(3));
    EXPECT_EQ((*made)[0].enclave, enclave("station1"));
    for (const char* file : {"cert.pem", "key.pem", "identity_ca.cert.pem", "permissions_ca.cert.pem",
                             "governance.p7s", "permissions.p7s"}) {
        EXPECT_TRUE(fs::exists(enclave("kurt3d") / file)) << file;
    }
    EXPECT_TRUE(securityFiles(enclave("kurt3d")).ok()) << complaintOf(securityFiles(enclave("kurt3d")));
}

TEST_F(Keys, AreReadableByTheirOwnerOnly) {
    ASSERT_TRUE(create(Team).ok());
    for (const fs::path& key :
         {m_store / "private/identity_ca.key.pem", m_store / "private/permissions_ca.key.pem",
          enclave("station1") / "key.pem", enclave("kurt3d") / "key.pem"}) {
        EXPECT_EQ(modeOf(key), 0600u) << key;
    }
    EXPECT_EQ(modeOf(m_store / "private"), 0700u);
    fs::permissions(enclave("kurt3d") / "key.pem", fs::perms::group_read, fs::perm_options::add);
    EXPECT_THAT(complaintOf(securityFiles(enclave("kurt3d"))), HasSubstr("chmod 600"));
}

TEST_F(Keys, NamesTheirSubjectInTheOrderOfRfc2253) {
    ASSERT_TRUE(create(Team).ok());
    EXPECT_THAT(readText(enclave("kurt3d") / "permissions.xml"),
                HasSubstr("<subject_name>CN=kurt3d,OU=robot,O=leitstand</subject_name>"));
}

TEST_F(Keys, HaveAnAuthorityForIdentitiesAndAnotherForPermissions) {
    ASSERT_TRUE(create(Team).ok());
    EXPECT_NE(readText(m_store / "public/identity_ca.cert.pem"),
              readText(m_store / "public/permissions_ca.cert.pem"));
    fs::copy_file(m_store / "public/identity_ca.cert.pem", m_store / "public/permissions_ca.cert.pem",
                  fs::copy_options::overwrite_existing);
    fs::copy_file(m_store / "private/identity_ca.key.pem", m_store / "private/permissions_ca.key.pem",
                  fs::copy_options::overwrite_existing);
    EXPECT_THAT(complaintOf(create({{KeyRole::Viewer, "other", {}, false}})),
                HasSubstr("sign permissions for himself"));
}

TEST_F(Keys, AreNeverOverwritten) {
    ASSERT_TRUE(create(Team).ok());
    const std::string key = readText(enclave("kurt3d") / "key.pem");
    const std::string authority = readText(m_store / "private/identity_ca.key.pem");
    const std::string text =
        complaintOf(create({{KeyRole::Robot, "crawler", {}, false}, {KeyRole::Viewer, "kurt3d", {}, false}}));
    EXPECT_THAT(text, StartsWith(enclave("kurt3d").string() + ": is there already"));
    EXPECT_FALSE(fs::exists(enclave("crawler"))) << "nothing is made when one request fails";
    ASSERT_TRUE(create({{KeyRole::Robot, "crawler", {}, false}}).ok());
    EXPECT_EQ(readText(enclave("kurt3d") / "key.pem"), key);
    EXPECT_EQ(readText(m_store / "private/identity_ca.key.pem"), authority);
    EXPECT_TRUE(securityFiles(enclave("crawler")).ok());
}

TEST_F(Keys, AreRenewedWithTheOldOnesKept) {
    ASSERT_TRUE(create(Team).ok());
    const std::string key = readText(enclave("kurt3d") / "key.pem");
    const std::string serial = readKeystore(m_store)->identities[1].serial;
    KeySettings settings;
    settings.renew = true;
    ASSERT_TRUE(create({{KeyRole::Robot, "kurt3d", {}, false}}, settings).ok());
    EXPECT_NE(readText(enclave("kurt3d") / "key.pem"), key);
    EXPECT_EQ(readText(m_store / "retired" / ("kurt3d-" + serial) / "key.pem"), key);
}

TEST_F(Keys, RefuseOddNames) {
    for (const std::string name : {"", "kurt 3d", "../x", "a,CN=b", "1robot", "k<b>", "ä", ".new"}) {
        EXPECT_THAT(complaintOf(create({{KeyRole::Robot, name, {}, false}})), HasSubstr("expected letters"))
            << name;
    }
    EXPECT_THAT(complaintOf(create({{KeyRole::Robot, "a", {"rt/a b"}, false}})), HasSubstr("rt/a b"));
    EXPECT_THAT(complaintOf(create({{KeyRole::Robot, "a", {"/scan"}, false}})), HasSubstr("rt/scan"));
    EXPECT_THAT(complaintOf(create({{KeyRole::Robot, "a", {}, false}, {KeyRole::Viewer, "a", {}, false}})),
                HasSubstr("twice"));
    EXPECT_FALSE(fs::exists(m_store)) << "nothing is made of a refused request";
}

TEST_F(Keys, TellWhereTheyCannotBeMade) {
    writeText(m_folder / "file", "");
    EXPECT_THAT(complaintOf(createKeys(m_folder / "file" / "keys", Team)), HasSubstr("cannot be made"));
    writeText(m_folder / "notes.txt", "");
    EXPECT_THAT(complaintOf(createKeys(m_folder.path(), Team)), HasSubstr("expected a keystore"));
    // Root may write everywhere else.
    EXPECT_THAT(complaintOf(createKeys("/proc/leitstand", Team)),
                HasSubstr("/proc/leitstand: cannot be made"));
}

TEST_F(Keys, TellWhenTheyExpired) {
    KeySettings past;
    past.now -= std::chrono::hours(24 * 400);
    ASSERT_TRUE(create(Team, past).ok());
    EXPECT_THAT(complaintOf(securityFiles(enclave("coach"))), HasSubstr("cert.pem: expired on"));
    const auto store = readKeystore(m_store);
    ASSERT_TRUE(store.ok());
    EXPECT_THAT(store->identities[0].problem, HasSubstr("expired"));
    EXPECT_THAT(complaintOf(securityFiles(enclave("coach"), past.now - std::chrono::hours(48))),
                HasSubstr("is valid from"));
    KeySettings tooLong;
    tooLong.authorityDays = 10;
    EXPECT_THAT(complaintOf(create({{KeyRole::Viewer, "b", {}, false}}, tooLong)), HasSubstr("authorities"));
}

TEST_F(Keys, TellFilesOfAnotherKeystore) {
    ASSERT_TRUE(create(Team).ok());
    ASSERT_TRUE(createKeys(m_folder / "foreign", Team).ok());
    const auto swap = [&](const char* file, const char* from) {
        fs::copy_file(m_folder / "foreign" / "enclaves" / from / file, enclave("kurt3d") / file,
                      fs::copy_options::overwrite_existing);
        return complaintOf(securityFiles(enclave("kurt3d")));
    };
    EXPECT_THAT(swap("permissions.p7s", "kurt3d"), HasSubstr("permissions authority's signature"));
    EXPECT_THAT(swap("permissions_ca.cert.pem", "kurt3d"), HasSubstr("governance.p7s"));
    EXPECT_THAT(swap("key.pem", "kurt3d"), HasSubstr("key.pem: expected the key of cert.pem"));
    EXPECT_THAT(swap("cert.pem", "kurt3d"), HasSubstr("different keystores"));
    fs::remove(enclave("kurt3d") / "cert.pem");
    EXPECT_THAT(complaintOf(securityFiles(enclave("kurt3d"))), HasSubstr("cert.pem: cannot be opened"));
}

TEST_F(Keys, TellThePermissionsOfAnother) {
    ASSERT_TRUE(create(Team).ok());
    fs::copy_file(enclave("station1") / "permissions.p7s", enclave("coach") / "permissions.p7s",
                  fs::copy_options::overwrite_existing);
    EXPECT_THAT(complaintOf(securityFiles(enclave("coach"))), HasSubstr("expected permissions for CN=coach"));
}

TEST_F(Keys, AreRevokedForEveryone) {
    ASSERT_TRUE(create(Team).ok());
    const fs::path stolen = m_folder / "stolen";
    fs::copy(enclave("coach"), stolen);
    const auto revoked = revokeKeys(m_store, "coach");
    ASSERT_TRUE(revoked.ok()) << revoked.error().text;
    EXPECT_EQ(*revoked, 1);
    EXPECT_FALSE(fs::exists(enclave("coach")));
    EXPECT_TRUE(securityFiles(enclave("kurt3d")).ok()) << complaintOf(securityFiles(enclave("kurt3d")));
    fs::copy_file(enclave("kurt3d") / "identity_ca.cert.pem", stolen / "identity_ca.cert.pem",
                  fs::copy_options::overwrite_existing);
    EXPECT_THAT(complaintOf(securityFiles(stolen)), HasSubstr("revoked"));
    const auto store = readKeystore(m_store);
    ASSERT_THAT(store->identities, SizeIs(3));
    EXPECT_TRUE(store->identities[0].revoked);
    EXPECT_THAT(revokeKeys(m_store, "coach").error().text, HasSubstr("no certificate"));
    ASSERT_TRUE(create({{KeyRole::Viewer, "coach", {}, false}}).ok()) << "the name can be given anew";
    EXPECT_TRUE(securityFiles(enclave("coach")).ok()) << complaintOf(securityFiles(enclave("coach")));
    EXPECT_EQ(*revokeKeys(m_store, "kurt3d"), 1);
    EXPECT_TRUE(readKeystore(m_store)->identities[1].revoked) << "earlier revocations stay";
    EXPECT_TRUE(securityFiles(enclave("coach")).ok()) << "and nothing else is revoked";
}

TEST_F(Keys, SayInALineWhetherTheDomainIsSecured) {
    EXPECT_THAT(securityLine(std::nullopt), HasSubstr("OFF"));
    ASSERT_TRUE(create(Team).ok());
    EXPECT_THAT(securityLine(*securityFiles(enclave("station1"))),
                StartsWith("Security is on: station1 (station), valid until 20"));
}

}  // namespace
}  // namespace leitstand::test
