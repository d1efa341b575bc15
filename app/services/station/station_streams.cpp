#include "app/services/station/station_streams.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/words.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

/// Rates are taken over 5 s; after this time they are those of a wish.
constexpr std::chrono::seconds Settling{6};
constexpr std::uint64_t Enough = 20;  ///< samples, after which a stream's cost is trusted

bool comesFrom(const RobotDescription& robot, const std::string& topic) {
    return std::any_of(robot.streams.begin(), robot.streams.end(), [&](const StreamDescription& stream) {
        return stream.topic == topic && !isCommand(stream.role);
    });
}

}  // namespace

StationStreams::StationStreams(std::vector<RobotDescription> robots, Send send, Pause pause)
    : m_send(std::move(send)), m_pause(std::move(pause)) {
    for (RobotDescription& robot : robots) m_lines.push_back(Line{.robot = std::move(robot)});
    if (!m_lines.empty()) m_selected = m_lines.front().robot.name;
}

StationStreams::Line* StationStreams::find(const std::string& robot) {
    const auto found = std::find_if(m_lines.begin(), m_lines.end(),
                                    [&](const Line& line) { return line.robot.name == robot; });
    return found == m_lines.end() ? nullptr : &*found;
}

const StationStreams::Line* StationStreams::find(const std::string& robot) const {
    return const_cast<StationStreams*>(this)->find(robot);
}

Result<void> StationStreams::request(const std::string& robot, const std::string& topic,
                                     const StreamRequest& request) {
    const std::lock_guard lock(m_mutex);
    Line* const line = find(robot);
    if (line == nullptr)
        return Error{leitstand::fill(
            translate("leitstand::Station", "\"{}\" is none of the station's robots"), robot)};
    if (line->robot.stream(StreamRole::StreamCommand) == nullptr)
        return Error{leitstand::fill(
            translate("leitstand::Station", "{}: its file names no stream_command stream"), robot)};
    if (!comesFrom(line->robot, topic))
        return Error{leitstand::fill(
            translate("leitstand::Station", "{}: {} is none of the streams that it sends"), robot, topic)};
    line->requests.set(topic, request);
    share();
    return {};
}

StreamRequest StationStreams::own(const std::string& robot, const std::string& topic) const {
    const std::lock_guard lock(m_mutex);
    const Line* const line = find(robot);
    return line == nullptr ? StreamRequest{} : line->requests.own(topic);
}

StreamRequest StationStreams::effective(const std::string& robot, const std::string& topic) const {
    const std::lock_guard lock(m_mutex);
    const Line* const line = find(robot);
    return line == nullptr ? StreamRequest{} : line->requests.effective(topic);
}

bool StationStreams::takesRequests(const std::string& robot) const {
    const std::lock_guard lock(m_mutex);
    const Line* const line = find(robot);
    return line != nullptr && line->robot.stream(StreamRole::StreamCommand) != nullptr;
}

void StationStreams::thin(const std::string& robot, bool on) {
    const std::lock_guard lock(m_mutex);
    for (Line& line : m_lines) {
        if (robot.empty() || line.robot.name == robot) line.thin = on;
    }
    share();
}

bool StationStreams::isThin(const std::string& robot) const {
    const std::lock_guard lock(m_mutex);
    return std::any_of(m_lines.begin(), m_lines.end(), [&](const Line& line) {
        return line.thin && (robot.empty() || line.robot.name == robot);
    });
}

void StationStreams::setThin(const ThinSettings& settings) {
    const std::lock_guard lock(m_mutex);
    m_settings = settings;
    share();
}

ThinSettings StationStreams::thinSettings() const {
    const std::lock_guard lock(m_mutex);
    return m_settings;
}

void StationStreams::select(const std::string& robot) {
    const std::lock_guard lock(m_mutex);
    if (robot == m_selected || find(robot) == nullptr) return;
    m_selected = robot;
    share();
}

void StationStreams::selectCamera(const std::string& robot, const std::string& sensor) {
    const std::lock_guard lock(m_mutex);
    Line* const line = find(robot);
    if (line == nullptr || line->camera == sensor) return;
    line->camera = sensor;
    share();
}

void StationStreams::add(const RobotDescription& robot) {
    const std::lock_guard lock(m_mutex);
    if (find(robot.name) != nullptr) return;
    m_lines.push_back(Line{.robot = robot});
    m_lines.back().thin = m_lines.front().thin;
    share();
}

void StationStreams::share() {
    std::vector<ThinRobot> robots;
    for (const Line& line : m_lines) {
        ThinRobot robot;
        robot.name = line.robot.name;
        robot.thin = line.thin && line.robot.stream(StreamRole::StreamCommand) != nullptr;
        robot.selected = line.robot.name == m_selected;
        for (const StreamDescription& stream : line.robot.streams) {
            if (isCommand(stream.role) || !line.requests.own(stream.topic).enabled) continue;
            const auto known = line.costs.find(stream.topic);
            StreamCost cost{.role = stream.role, .topic = stream.topic};
            if (known != line.costs.end()) cost = known->second;
            // A robot that is not there costs nothing, nor does a stream that never came.
            if (!line.there || (known == line.costs.end() && line.costs.size() > 3)) cost.megabits = 0.0;
            if ((stream.role == StreamRole::Picture || stream.role == StreamRole::Thermal) &&
                stream.sensor == line.camera)
                robot.camera = stream.topic;
            robot.streams.push_back(std::move(cost));
        }
        robots.push_back(std::move(robot));
    }
    const auto requests = thinRequests(robots, m_settings);
    for (Line& line : m_lines) {
        std::map<std::string, StreamRequest> own;
        for (const StreamDescription& stream : line.robot.streams) {
            if (const auto request = requests.find(stream.topic); line.thin && request != requests.end())
                own.insert(*request);
        }
        line.requests.setThin(own);
    }
}

bool StationStreams::isSettled(Line& line, const std::string& topic, const StreamRequest& request) {
    const SteadyTime now = std::chrono::steady_clock::now();
    const auto [standing, isNew] = line.standing.try_emplace(topic, Standing{request, now});
    if (standing->second.request != request) standing->second = {request, now};
    return now - standing->second.since > Settling;
}

bool StationStreams::correct(Line& line, const StreamStatus& stream, const StreamRequest& request) {
    if (!request.enabled || !isFollowed(request, stream)) return false;
    const auto known = line.costs.find(stream.topic);
    StreamCost cost = known == line.costs.end() ? usualCost(stream.role, stream.topic) : known->second;
    const double expected = costUnder(cost, request),
                 measured = onTheWire(stream.megabitsPerSecond, stream.rate);
    if (expected <= 0.0 || measured <= 1.05 * expected) return false;
    cost.megabits *= measured / expected;
    line.costs[stream.topic] = cost;
    return true;
}

bool StationStreams::learn(Line& line, const LinkStatus& link) {
    bool news = false;
    for (const StreamStatus& stream : link.streams) {
        const StreamRequest request = line.requests.effective(stream.topic);
        const bool settled = isSettled(line, stream.topic, request);
        if (stream.samples < Enough || stream.rate <= 0.0) continue;
        if (!request.isPlain()) {
            news = (settled && correct(line, stream, request)) || news;
            continue;
        }
        const auto [known, isNew] = line.costs.try_emplace(stream.topic);
        StreamCost& cost = known->second;
        // A stream that a thin link just released is still rising to its full cost.
        const double before = std::max(cost.megabits, 0.0);
        const double measured = onTheWire(stream.megabitsPerSecond, stream.rate);
        const double now = line.thin ? std::max(before, measured) : measured;
        news = news || isNew || now > 1.3 * before + 0.05;
        cost = {stream.role, stream.topic, std::max(stream.rate, stream.expectedRate), now};
    }
    return news && line.thin;
}

void StationStreams::take(const LinkStatus& link) {
    std::vector<StreamCommandSample> due;
    std::vector<std::pair<std::string, bool>> paused;
    {
        const std::lock_guard lock(m_mutex);
        Line* const line = find(link.robot);
        if (line == nullptr) return;
        const bool there = link.state == LinkState::Connected || link.state == LinkState::Degraded;
        if (there && !line->there) line->requests.returned();
        const bool otherTeam = std::exchange(line->there, there) != there;
        const bool news = there && learn(*line, link);
        if (otherTeam || news) share();
        if (!there) return;  // nobody listens
        due = line->requests.due(std::chrono::steady_clock::now());
        for (const StreamStatus& stream : link.streams) {
            const bool off = !line->requests.effective(stream.topic).enabled;
            if (off != stream.paused) paused.emplace_back(stream.topic, off);
        }
    }
    for (const auto& [topic, off] : paused) m_pause(link.robot, topic, off);
    for (const StreamCommandSample& command : due) {
        (void)m_send(link.robot, command);  // sent again until it is followed
    }
}

}  // namespace leitstand
