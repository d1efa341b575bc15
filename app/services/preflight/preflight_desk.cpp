#include "app/services/preflight/preflight_desk.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <set>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "app/services/log/sequencer.h"
#include "app/services/preflight/network_cards.h"
#include "app/services/station/safety/station_alarms.h"
#include "app/services/station/safety/station_brakes.h"
#include "app/services/station/safety/station_guards.h"
#include "app/services/station/station.h"
#include "core/base/time.h"
#include "core/base/words.h"
#include "core/event/stream_role.h"
#include "transport/domain/join_settings.h"

namespace leitstand {
namespace {

constexpr std::size_t Piece = 1U << 20U;  ///< [B]

bool speaksOf(const WireComplaint& complaint, const std::string& robot) {
    return complaint.topic.starts_with("/" + robot + "/");
}

}  // namespace

Result<double> measureDisk(const std::filesystem::path& folder, int megabytes) {
    const std::filesystem::path file = folder / ".disk-test";
    const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (out < 0)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be written: {}"),
                                     file.string(), std::strerror(errno))};
    std::vector<char> bytes(Piece);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 2'654'435'761U >> 13U);
    const auto began = std::chrono::steady_clock::now();
    bool good = true;
    for (int i = 0; i < megabytes && good; ++i)
        good = ::write(out, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    good = good && ::fdatasync(out) == 0;
    const int why = errno;
    const double seconds = toSeconds(std::chrono::steady_clock::now() - began);
    ::close(out);
    ::unlink(file.c_str());
    if (!good)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be written: {}"),
                                     file.string(), std::strerror(why))};
    return static_cast<double>(megabytes) * static_cast<double>(Piece) / std::max(seconds, 1e-6);
}

PreflightDesk::PreflightDesk(Station& station) : m_station(station) {
    measure();
}

void PreflightDesk::measure() {
    if (m_busy.exchange(true)) return;  // never waits for a slow disk here
    m_measuring = std::jthread([this, folder = m_station.settings().mission.folder] {
        const auto rate = measureDisk(folder);
        const std::lock_guard lock(m_mutex);
        m_rate = rate ? std::optional(*rate) : std::nullopt;  // the log reports what is wrong with it
        m_busy = false;
    });
}

std::vector<RobotGuess> PreflightDesk::strangers() const {
    std::set<std::string> ours;
    for (const RobotDescription& robot : m_station.robots()) ours.insert(robot.name);
    std::vector<RobotGuess> others;
    for (RobotGuess& guess : guessRobots(m_station.visibleTopics())) {
        const bool sees = guess.robot.stream(StreamRole::Odometry) != nullptr ||
                          guess.robot.stream(StreamRole::Points) != nullptr ||
                          guess.robot.stream(StreamRole::Picture) != nullptr;
        if (sees && !ours.contains(guess.robot.name)) others.push_back(std::move(guess));
    }
    return others;
}

PreflightFacts PreflightDesk::facts(const std::string& gamepad) const {
    PreflightFacts facts;
    facts.now = stationTime();
    const StationSettings& settings = m_station.settings();
    std::vector<WireComplaint> complaints = m_station.mismatches();
    for (const RobotDescription& robot : m_station.robots()) {
        RobotFacts one;
        one.robot = robot;
        one.view = m_station.robot(robot.name);
        one.brake = m_station.brakes().result(robot.name);
        one.brakeOverridden = m_station.brakes().isOverridden(robot.name);
        one.guard = m_station.guards().view(robot.name);
        const auto own =
            std::stable_partition(complaints.begin(), complaints.end(),
                                  [&](const WireComplaint& one) { return !speaksOf(one, robot.name); });
        one.complaints.assign(own, complaints.end());
        complaints.erase(own, complaints.end());
        facts.robots.push_back(std::move(one));
    }
    facts.complaints = std::move(complaints);
    for (const RobotGuess& stranger : strangers()) facts.strangers.push_back(stranger.robot.name);
    facts.limits = m_station.limits();
    facts.cards = networkCards(settings.domain.interfaces);
    facts.environment = settings.domain.fromEnvironment;
    facts.folder = settings.mission.folder.string();
    std::error_code ignored;
    facts.freeBytes = std::filesystem::space(settings.mission.folder, ignored).available;
    const LiveMissionStatus log = m_station.log();
    facts.logRate = log.bytesPerSecond;
    facts.logProblem = log.problem;
    {
        const std::lock_guard lock(m_mutex);
        facts.writeRate = m_rate;
    }
    facts.farClock = m_station.alarms().limits().clock;
    facts.gamepad = gamepad;
    facts.secured = isSecured(settings.domain);
    facts.security = securityLine(settings.domain);
    facts.versions = {"Leitstand " + settings.mission.version};
    return facts;
}

}  // namespace leitstand
