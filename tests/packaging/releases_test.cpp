// The version is told in several places, and is one.
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/version/version.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
/// Version and date.
using Releases = std::vector<std::pair<std::string, std::string>>;

Releases found(const std::string& text, const std::string& pattern) {
    const std::regex release(pattern);
    Releases all;
    for (std::sregex_iterator one(text.begin(), text.end(), release), end; one != end; ++one)
        all.emplace_back((*one)[1], (*one)[2]);
    return all;
}

Releases ofChangelog() {
    return found(readText(fs::path(sourceFolder()) / "CHANGELOG.md"),
                 "\n## (\\d+\\.\\d+\\.\\d+) \\((\\d{4}-\\d\\d-\\d\\d)\\)\n");
}

TEST(Releases, TheNewestOfTheChangelogIsTheVersion) {
    ASSERT_FALSE(ofChangelog().empty());
    EXPECT_EQ(ofChangelog().front().first, version());
}

TEST(Releases, ComeNewestFirst) {
    const Releases all = ofChangelog();
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i].second, all[i - 1].second) << all[i].first;
}

TEST(Releases, AreAllToldToSoftwareCentres) {
    const std::string metainfo =
        readText(fs::path(sourceFolder()) / "packaging/desktop/org.leitstand.leitstand.metainfo.xml");
    EXPECT_EQ(found(metainfo, "<release version=\"([^\"]*)\" date=\"([^\"]*)\""), ofChangelog());
}

TEST(Releases, BecomeDebiansChangelog) {
    const TemporaryFolder folder;
    const std::string source = sourceFolder() + "/packaging/deb/changelog.py";
    const ProcessOutcome made =
        runProcess("/usr/bin/env", {"PYTHONDONTWRITEBYTECODE=1", "python3", source,
                                    sourceFolder() + "/CHANGELOG.md", (folder / "changelog").string()});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const Releases entries = found("\n" + readText(folder / "changelog"),
                                   "\nleitstand \\(([0-9.]+)\\) (unstable); urgency=medium\n");
    ASSERT_EQ(entries.size(), ofChangelog().size());
    EXPECT_EQ(entries.front().first, version());
}

TEST(Releases, AChangelogWithoutAnyIsRefused) {
    const TemporaryFolder folder;
    writeText(folder / "CHANGELOG.md", "# Changelog\n\n## Unreleased\n\n- one\n");
    const std::string source = sourceFolder() + "/packaging/deb/changelog.py";
    const ProcessOutcome made =
        runProcess("/usr/bin/env", {"PYTHONDONTWRITEBYTECODE=1", "python3", source,
                                    (folder / "CHANGELOG.md").string(), (folder / "changelog").string()});
    EXPECT_EQ(made.exitCode, 1);
    EXPECT_THAT(made.err, testing::HasSubstr("expected a heading such as"));
}

}  // namespace
}  // namespace leitstand::test
