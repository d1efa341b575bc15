#include "tests/app/soak/played_demo.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "app/services/log/replay/replay_rules.h"
#include "app/services/log/sequencer.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/soak/demo_recording.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds Recorded(120);  ///< and the way back
constexpr double Calm = 0.5;                   ///< cores of a station that has worked off all that came
constexpr std::chrono::seconds Behind(2);      ///< at most, is its log then
constexpr std::chrono::minutes WorkOff(2);     ///< at most

}  // namespace

std::filesystem::path recordedDemo(const std::filesystem::path& folder) {
    constexpr int Attempts = 3;
    if (const char* recorded = std::getenv("LEITSTAND_SOAK_DEMO")) return recorded;
    for (int attempt = 1;; ++attempt) {
        const auto demo = folder / ("demo_" + std::to_string(attempt));
        try {
            recordDemo(demo, Recorded);
            return demo;
        } catch (const std::runtime_error& problem) {
            std::printf("recording %d of %d: %s\n", attempt, Attempts, problem.what());
            std::fflush(stdout);
            if (attempt == Attempts) throw;
        }
    }
}

std::unique_ptr<MissionReplay> replayOf(const std::filesystem::path& mission, int domain, double rate,
                                        bool loop) {
    ReplaySettings settings;
    settings.mission = mission;
    settings.domain.domain = domain;
    settings.domain.interfaces = {"lo"};
    settings.rate = rate;
    settings.loop = loop;
    return must(MissionReplay::open(settings));
}

Playing::Playing(const std::filesystem::path& mission, int domain, double rate)
    : m_replay(replayOf(mission, domain, rate, true)), m_thread([this](const std::stop_token& stop) {
          const Progress progress{[this](double fraction) { note(fraction); }, stop};
          m_outcome = m_replay->play(m_paused, progress);
      }) {}

ReplayOutcome Playing::end() {
    m_thread.request_stop();
    m_thread.join();
    return m_outcome;
}

void Playing::note(double fraction) {
    if (fraction < m_fraction) ++m_whole;
    m_fraction = fraction;
    m_rounds = m_whole + fraction;
}

std::map<std::string, std::uint64_t> messagesIn(const std::filesystem::path& mission) {
    const auto bag = must(BagReader::open(mission));
    bag->count();
    std::map<std::string, std::uint64_t> counts;
    for (const BagTopic& topic : bag->topics()) {
        if (!isReplayable(topic.info.name, topic.info.type) || topic.info.type.ends_with("Image")) continue;
        counts[topic.info.name] += topic.messages.value_or(0);
    }
    return counts;
}

double secondsOf(const std::filesystem::path& mission) {
    const auto bag = must(BagReader::open(mission));
    return std::chrono::duration<double>(bag->last() - bag->first()).count();
}

Logged loggedIn(const std::filesystem::path& mission) {
    const auto bag = must(BagReader::open(mission));
    bag->count();
    Logged logged{bag->last(), 0, 0, bag->lastSequence()};
    for (const BagTopic& topic : bag->topics()) {
        logged.events += topic.messages.value_or(0);
        if (topic.info.name == station_topic::KeyScans) logged.keyScans = topic.messages.value_or(0);
    }
    return logged;
}

bool worksOff(const StationProcess& station) {
    auto since = Clock::now();
    double used = station.processorSeconds();
    return waitUntil(
        [&] {
            const double passed = std::chrono::duration<double>(Clock::now() - since).count();
            if (passed < 1.0) return false;
            const double cores = (station.processorSeconds() - used) / passed;
            since = Clock::now();
            used = station.processorSeconds();
            if (cores > Calm) return false;
            return stationTime() - loggedIn(station.mission()).last < Behind;
        },
        WorkOff);
}

}  // namespace leitstand::test
