// Names that others chose, full of control characters and bytes that are no UTF-8: JSON stays JSON, and a
// terminal shows them.
#include <algorithm>
#include <chrono>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/bag/bag_writer.h"
#include "tests/app/recording.h"
#include "tests/support/attack.h"
#include "tests/support/temporary_folder.h"
#include "transport/dds/node.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// Clears the screen, sets the title, writes backwards; no UTF-8 at its end.
constexpr auto Hostile =
    "/kurt3d/\x1b[2J\x1b]0;owned\x07\xc2\x9b"
    "31m\xe2\x80\xae\r\n\xff\xfe";

/// Bytes that a terminal would obey.
std::size_t obeyed(const std::string& text) {
    std::size_t count = static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        const auto value = static_cast<unsigned char>(byte);
        return (value < 0x20 && byte != '\n') || value == 0x7f;
    }));
    for (const char* sequence : {"\xc2\x9b", "\xe2\x80\xae", "\xff", "\xfe"}) {
        for (auto at = text.find(sequence); at != std::string::npos; at = text.find(sequence, at + 1))
            ++count;
    }
    return count;
}

/// @p command with and without --json: both end well and print nothing that is obeyed; the JSON.
json bothWays(std::vector<std::string> command, int exitCode = 0) {
    const auto words = leitstandctl(command);
    EXPECT_EQ(words.exitCode, exitCode) << command[0] << ": " << words.err;
    EXPECT_EQ(obeyed(words.out + words.err), 0U) << command[0];
    command.push_back("--json");
    const auto reported = leitstandctl(command);
    EXPECT_EQ(reported.exitCode, exitCode) << command[0] << ": " << reported.err;
    EXPECT_EQ(obeyed(reported.out + reported.err), 0U) << command[0];
    return json::parse(reported.out, nullptr, false);
}

void writeHostileBag(const fs::path& mission) {
    const auto writer = std::move(BagWriter::open(mission)).value();
    TopicInfo topic{.name = Hostile, .type = "std_msgs/msg/Float32"};
    writer->addTopic(topic);
    const auto cdr = std::make_shared<const std::vector<std::byte>>(8, std::byte{0});
    for (std::uint64_t i = 1; i <= 3; ++i)
        writer->write({i, Time(std::chrono::seconds(1'767'225'600) + std::chrono::milliseconds(i)),
                       topic.name, topic.type, cdr});
    ASSERT_TRUE(writer->close());
}

TEST(HostileNames, OfTopicsAndFilesAreShownNotObeyed) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "a\x1b[31m\xff";
    writeHostileBag(mission);
    const TestDomain domain;
    const json info = bothWays({"info", mission.string()});
    EXPECT_EQ(info["events"], 3);
    EXPECT_THAT(info["topics"][0]["topic"].get<std::string>(), HasSubstr("\x1b[2J"))
        << "JSON keeps what it can tell";
    EXPECT_TRUE(
        bothWays({"replay", mission.string(), "--domain", std::to_string(domain.number())}).is_object());
    for (const char* out : {"thin1", "thin2"}) {
        const auto reported =
            leitstandctl({"thin", mission.string(), "--out", (folder / out).string(), "--json"});
        EXPECT_EQ(reported.exitCode, 0) << reported.err;
        EXPECT_EQ(obeyed(reported.out + reported.err), 0U);
    }
    (void)leitstandctl(
        {"report", mission.string(), "--out", (folder / "report").string(), "--no-pdf", "--json"});
    const auto missing = leitstandctl({"info", (folder / "b\x1b[2J\xff").string()});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_EQ(obeyed(missing.err), 0U);
    // Scans of such names, and keys in such folders.
    const fs::path scan = folder / "c\x1b[2J\xff.xyz";
    std::string points;
    for (int i = 0; i < 2'000; ++i)
        points += fmt::format("{} {} {}\n", 0.1 * (i % 40), 0.1 * (i / 40), 0.01 * ((i * 7) % 13));
    writeText(scan, points);
    const json scans = bothWays({"register", scan.string(), scan.string()});
    EXPECT_EQ(scans["scans"].size(), 2U);
    const auto table1 = leitstandctl({"table1", scan.string(), scan.string(), "--json"});
    EXPECT_EQ(obeyed(table1.out + table1.err), 0U);
    const fs::path keys = folder / "d\x1b[2J\xff";
    ASSERT_EQ(leitstandctl({"keys", "--out", keys.string(), "--robot", "kurt3d"}).exitCode, 0);
    EXPECT_TRUE(bothWays({"keys", "show", keys.string()}).is_object());
    tellAttack(
        "log",
        "names with control characters and bytes that are no UTF-8 (info, replay, thin, register, keys)", 14,
        "JSON is whole, nothing reaches the terminal raw");
}

TEST(HostileNames, OfTopicsOnTheWireAreShownNotObeyed) {
    const TemporaryFolder folder;
    const TestDomain domain;
    auto created = Node::create({.domain = domain.number()});
    ASSERT_TRUE(created) << created.error().text;
    const auto node = std::move(created).value();
    auto publisher = node->publisher({.topic = Hostile, .type = "std_msgs/msg/Float32"});
    ASSERT_TRUE(publisher) << publisher.error().text;
    const std::string number = std::to_string(domain.number());
    const json probed =
        bothWays({"probe", "--domain", number, "--seconds", "2", "--out", folder.path().string()});
    ASSERT_TRUE(probed.is_object());
    EXPECT_THAT(probed.dump(-1, ' ', false, json::error_handler_t::replace), HasSubstr("owned"));
    Recording recording(domain, folder / "mission", {"--json"});
    const auto cdr = std::make_shared<const std::vector<std::byte>>(8, std::byte{0});
    EXPECT_TRUE(waitUntil(
        [&] {
            (void)(*publisher)->write(cdr);
            return !recordedOn(folder / "mission", Hostile).empty();
        },
        std::chrono::seconds(60)));
    EXPECT_EQ(recording.stop(), 0) << recording.out();
    EXPECT_EQ(obeyed(recording.out()), 0U);
    tellAttack(
        "wire",
        "names of topics with control characters and bytes that are no UTF-8 (probe and record, times)", 3,
        "JSON is whole, nothing reaches the terminal raw");
}

TEST(HostileTimes, AReplayOfAnyTimesEnds) {
    const TemporaryFolder folder;
    const TestDomain domain;
    constexpr auto Least = std::numeric_limits<std::int64_t>::min(),
                   Most = std::numeric_limits<std::int64_t>::max();
    constexpr std::int64_t Begin = 1'767'225'600'000'000'000;
    const std::vector<std::int64_t> times = {Begin, Begin + 1'000, Most,         Begin + 2'000, Least, 0,
                                             -1,    Most - 1,      Begin + 3'000};
    {
        const auto writer = std::move(BagWriter::open(folder / "mission")).value();
        const TopicInfo topic{.name = "/kurt3d/x", .type = "std_msgs/msg/Float32"};
        writer->addTopic(topic);
        const auto cdr = std::make_shared<const std::vector<std::byte>>(8, std::byte{0});
        for (std::size_t i = 0; i < times.size(); ++i)
            writer->write({i + 1, Time(std::chrono::nanoseconds(times[i])), topic.name, topic.type, cdr});
        ASSERT_TRUE(writer->close());
    }
    const std::string mission = (folder / "mission").string();
    const auto began = std::chrono::steady_clock::now();
    const json replayed = bothWays({"replay", mission, "--domain", std::to_string(domain.number())});
    EXPECT_EQ(replayed["published"], times.size());
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() / 2.0;
    EXPECT_LT(seconds, 60.0);
    EXPECT_EQ(bothWays({"info", mission})["events"], times.size());
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
             {"thin", mission, "--out", (folder / "thin").string()},
             {"report", mission, "--out", (folder / "report").string(), "--no-pdf"},
             {"export", mission, "--out", (folder / "a.tum").string()},
             {"register", mission}}) {
        const auto outcome = leitstandctl(command);
        EXPECT_GE(outcome.exitCode, 0) << command[0] << " ends by itself: " << outcome.err;
    }
    tellAttack(
        "log", "times of 2^63-1, -2^63, 0 and -1 ns among others", times.size(),
        fmt::format(
            "the replay ends after {:.0f} s with all events; info, thin, report, export and register end",
            seconds));
}

}  // namespace
}  // namespace leitstand::test
