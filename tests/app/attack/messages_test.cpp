// What the screen drops is told, by every program that takes part in a domain.
#include <mutex>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/app/recording.h"
#include "tests/app/robots/robot_process.h"
#include "tests/app/station/station_scene.h"
#include "tests/transport/screen/packets.h"
#include "tests/transport/screen_wire/mutations.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::ContainsRegex;

constexpr auto Sentence = "somebody sends what is no RTPS: (one packet|[0-9,]+ packets) from 127.0.0.1";

/// A domain on loopback in which somebody sends 50 broken packets a second.
class DroppedPackets : public StationScene {
protected:
    /// Of leitstandctl and leitstand-robot.
    [[nodiscard]] std::vector<std::string> here(std::vector<std::string> words) const {
        words.insert(words.end(), {"--domain", std::to_string(m_domain.number()), "--interface", "lo"});
        return words;
    }

private:
    const std::jthread m_sending{[this](const std::stop_token& stop) {
        Attacker attacker(m_domain.number());
        while (!stop.stop_requested()) {
            attacker.send(Packet().submessage(0x80, 0, Bytes(60), 56).bytes());
            std::this_thread::sleep_for(20ms);
        }
    }};
};

TEST_F(DroppedPackets, AreToldByAStation) {
    StationSettings settings = settingsFor({kurt3d()});
    settings.domain.interfaces = {"lo"};
    std::mutex mutex;
    std::string words;
    StationListener listener;
    listener.onMessage = [&](const std::string& text) {
        const std::scoped_lock lock(mutex);
        words += text + "\n";
    };
    const auto station = must(Station::open(settings, std::move(listener)));
    const auto reported = [&] {
        const std::scoped_lock lock(mutex);
        return words;
    };
    EXPECT_TRUE(waitUntil([&] { return reported().find("no RTPS") != std::string::npos; }));
    EXPECT_THAT(reported(), ContainsRegex(Sentence));
}

TEST_F(DroppedPackets, AreToldByTheRecorderMeanwhileAndAtTheEnd) {
    ChildProcess recorder(program("leitstandctl"),
                          here({"record", "--json", "--out", (m_folder / "mission").string()}));
    ASSERT_TRUE(waitUntil([&] { return recorder.out().find("no RTPS") != std::string::npos; }, 60s))
        << recorder.out();
    EXPECT_THAT(recorder.out(), ContainsRegex(Sentence));
    recorder.signal(SIGTERM);
    EXPECT_EQ(recorder.wait(), 0);
    const std::string out = recorder.out();
    const auto begin = out.find("{\n"), end = out.rfind("\n}\n");
    ASSERT_TRUE(begin != std::string::npos && end != std::string::npos) << out;
    EXPECT_THAT(out.substr(end), ContainsRegex(Sentence)) << "after the summary";
    const json screened = json::parse(out.substr(begin, end + 2 - begin))["screened"];
    ASSERT_FALSE(screened.empty()) << out;
    EXPECT_THAT(screened[0]["what"].get<std::string>(), ContainsRegex(Sentence));
    EXPECT_EQ(screened[0]["from"], "127.0.0.1");
    EXPECT_GT(screened[0]["packets"], 0);
}

TEST_F(DroppedPackets, AreToldByAProbe) {
    const auto probed =
        leitstandctl(here({"probe", "--json", "--seconds", "3", "--out", m_folder.path().string()}));
    ASSERT_EQ(probed.exitCode, 0) << probed.err;
    EXPECT_THAT(probed.err, ContainsRegex(Sentence));
    const json warnings = json::parse(probed.out)["warnings"];
    EXPECT_THAT(warnings.get<std::vector<std::string>>(), testing::Contains(ContainsRegex(Sentence)));
}

TEST_F(DroppedPackets, AreToldByARobot) {
    const RobotProcess robot(m_domain, "kurt3d", {"--arena", "yellow", "--seed", "7", "--interface", "lo"});
    EXPECT_TRUE(waitUntil([&] { return robot.out().find("no RTPS") != std::string::npos; }, 60s));
    EXPECT_THAT(robot.out(), ContainsRegex(Sentence));
}

}  // namespace
}  // namespace leitstand::test
