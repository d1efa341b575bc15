#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/missing_tool.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/convert/conversion.h"
#include "transport/convert/message_catalog.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// A text as a JSON string.
std::string quoted(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) json += c == '\n' ? std::string("\\n") : std::string(1, c);
    return json + "\"";
}

/// The catalog as JSON: ROS name -> text.
fs::path writeCatalog(const TemporaryFolder& folder) {
    std::string json = "{";
    for (const MessageType& type : messageTypes()) {
        json += fmt::format("{}{}: {}", json.size() > 1 ? ",\n" : "", quoted(type.rosName),
                            quoted(type.definition));
    }
    writeText(folder / "catalog.json", json + "}");
    return folder / "catalog.json";
}

fs::path fileOf(const fs::path& folder, std::string_view type) {
    const auto slash = type.find('/');
    return folder / fmt::format("{}.{}.cdr", type.substr(0, slash), type.substr(type.rfind('/') + 1));
}

std::vector<std::byte> readBytes(const fs::path& file) {
    const std::string text = readText(file);
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

/// Runs a script of tests/idl with the npm packages.
ProcessOutcome runScript(const std::string& script, const std::vector<std::string>& arguments) {
    const fs::path tests = fs::path(sourceFolder()) / "tests";
    std::vector<std::string> all = {(tests / "idl" / script).string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return runProcess(tests / "npm" / "run", all);
}

// The packages know the message texts and CDR from elsewhere: a mistake in our IDL cannot be theirs too.
TEST(NpmPeer, AgreesOnTheLayoutOfEveryStandardMessage) {
    const TemporaryFolder folder;
    const auto outcome = runScript("layouts.js", {writeCatalog(folder).string()});
    LEITSTAND_NEEDS(outcome);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
}

TEST(NpmPeer, ReadsWhatOurEncoderWrites) {
    const TemporaryFolder folder;
    const fs::path samples = folder / "samples";
    fs::create_directory(samples);
    for (const SampleCase& one : sampleCases()) {
        const auto bytes = encoded(one);
        std::ofstream(fileOf(samples, one.type), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    const auto outcome = runScript("read.js", {writeCatalog(folder).string(), samples.string()});
    LEITSTAND_NEEDS(outcome);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
}

TEST(NpmPeer, WritesWhatOurDecoderReads) {
    const TemporaryFolder folder;
    const auto outcome = runScript("write.js", {writeCatalog(folder).string(), folder.path().string()});
    LEITSTAND_NEEDS(outcome);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    for (const MessageType& type : messageTypes()) {
        const auto theirs = readBytes(fileOf(folder.path(), type.rosName));
        ASSERT_GT(theirs.size(), 4u) << type.rosName;
        const auto ours = recoded(type.rosName, theirs, std::endian::little);
        ASSERT_TRUE(ours) << type.rosName << ": " << ours.error().text;
        EXPECT_EQ(*ours, theirs) << type.rosName;
    }
}

}  // namespace
}  // namespace leitstand::test
