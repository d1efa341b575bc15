#include "tests/app/robots/held_station.h"

#include <algorithm>
#include <iterator>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

std::vector<std::string> wordsFor(const std::filesystem::path& folder, const TestDomain& domain, double speed,
                                  const std::vector<std::string>& more) {
    std::vector<std::string> words = {folder.string(), std::to_string(domain.number()), "kurt3d",
                                      std::to_string(speed)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace

HeldStation::HeldStation(const std::filesystem::path& folder, const TestDomain& domain, double speed,
                         std::vector<std::string> more)
    : m_process(program("held_station"), wordsFor(folder, domain, speed, more)) {}

int HeldStation::reported() const {
    const std::string out = m_process.out();
    int count = 0;
    for (auto at = out.find("drives\n"); at != std::string::npos; at = out.find("drives\n", at + 1)) ++count;
    return count;
}

bool HeldStation::drives() const {
    return waitUntil([this] { return reported() >= m_awaited; }, std::chrono::seconds(60));
}

void HeldStation::turn() {
    ++m_awaited;
    m_process.signal(SIGUSR1);
}

TrueSpeed::TrueSpeed(const TestDomain& domain, const std::string& arena) {
    NodeSettings settings;
    settings.domain = domain.number() + TruthAbove;
    settings.name = "truth listener";
    settings.interfaces = {"lo"};  // as the robot
    m_node = must(Node::create(settings));
    StreamDescription stream;
    stream.role = StreamRole::Odometry;
    stream.topic = "/truth/" + arena + "/kurt3d";
    stream.type = "nav_msgs/msg/Odometry";
    stream.qos = bestEffort(50);
    m_listening = must(m_node->subscribe(
        {stream.topic, stream.type, stream.qos, Lane::Small}, [this, stream](const ReceivedSample& sample) {
            const auto pose = must(decode(sample.event, stream)).get<OdometrySample>();
            const double speed = std::max(pose.linear.norm(), 0.2 * std::abs(pose.angular.z()));
            const std::scoped_lock lock(m_mutex);
            m_speeds.emplace_back(sample.event.received, speed);
        }));
}

double TrueSpeed::now() const {
    const std::scoped_lock lock(m_mutex);
    return m_speeds.empty() ? 0.0 : m_speeds.back().second;
}

std::optional<double> TrueSpeed::stoodAfter(Time moment) const {
    const std::scoped_lock lock(m_mutex);
    std::optional<Time> stood;
    for (auto one = m_speeds.rbegin(); one != m_speeds.rend() && one->first > moment; ++one) {
        if (one->second >= Standing) break;
        stood = one->first;
    }
    if (!stood) return std::nullopt;
    return std::chrono::duration<double>(*stood - moment).count();
}

double TrueSpeed::longestGapSince(Time moment) const {
    const std::scoped_lock lock(m_mutex);
    double longest = 0.0;
    for (auto one = m_speeds.rbegin(); one != m_speeds.rend() && one->first > moment; ++one) {
        const auto before = std::next(one);
        if (before == m_speeds.rend()) break;
        longest = std::max(longest, std::chrono::duration<double>(one->first - before->first).count());
    }
    return longest;
}

double TrueSpeed::fastestSince(Time moment) const {
    const std::scoped_lock lock(m_mutex);
    double fastest = 0.0;
    for (auto one = m_speeds.rbegin(); one != m_speeds.rend() && one->first > moment; ++one)
        fastest = std::max(fastest, one->second);
    return fastest;
}

}  // namespace leitstand::test
