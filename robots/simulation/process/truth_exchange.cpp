#include "robots/simulation/process/truth_exchange.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "robots/simulation/process/point_labels.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand::simulation {
namespace {

constexpr auto Period = std::chrono::milliseconds(20);
constexpr auto Forgotten = std::chrono::seconds(5);
constexpr std::size_t MostGhosts = 8;
const std::string Frame = "arena";
const Qos Poses{.reliability = Qos::Reliability::BestEffort, .depth = 1};
const Qos Lasting{.durability = Qos::Durability::TransientLocal, .depth = 10};
const Qos AllLabels{.depth = 100};

StreamDescription odometryOn(const std::string& topic) {
    StreamDescription stream;
    stream.role = StreamRole::Odometry;
    stream.topic = topic;
    stream.type = "nav_msgs/msg/Odometry";
    stream.qos = Poses;
    return stream;
}

SightingSample victimsOf(const Arena& arena, Time now) {
    SightingSample victims;
    victims.header = {now, Frame};
    for (const Element& element : arena.elements) {
        if (!element.victim) continue;
        Sighting victim;
        victim.id = static_cast<std::uint32_t>(victims.sightings.size() + 1);
        victim.kind = "victim";
        victim.position = element.pose.translation();
        victim.deviation = 0.0;
        victim.confidence = 1.0;
        victim.value = element.victim->temperature;
        victim.text = element.victim->tag;
        victims.sightings.push_back(victim);
    }
    return victims;
}

void write(Publisher& publisher, const Sample& sample) {
    if (const auto cdr = encode(sample, typeOf(sample))) static_cast<void>(publisher.write(*cdr));
}

}  // namespace

std::string topicPart(const Arena& arena) {
    std::string part = arena.name;
    for (char& letter : part) {
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
    }
    return part.empty() ? "arena" : part;
}

struct TruthExchange::State {
    State(const RobotDescription& description, int its)
        : name(description.name), robot(its), pointLabels(description, its) {}
    struct Received {
        std::string kind;
        Pose baseInArena = Pose::Identity();
        Time at{};
        bool fresh = false;
    };
    struct Ghost {
        int number = 0;
        bool there = false;
    };

    Result<void> open(Node& node, const Arena& arena);
    void receive(const std::string& kind, const StreamDescription& stream, const ReceivedSample& sample);

    std::string kind;
    const std::string name;
    const int robot;
    const PointLabels pointLabels;
    std::unique_ptr<Publisher> poses, victims, contacts, labels;
    std::map<std::string, Ghost> ghosts;
    BumpSample bumps;
    std::size_t bumpsSeen = 0;
    Time published{};
    bool victimsPublished = false;
    SightingSample allVictims;
    std::mutex mutex;
    std::map<std::string, Received> others;                    ///< by name; guarded by the mutex
    std::vector<std::unique_ptr<Subscription>> subscriptions;  ///< last: callbacks use the members above
};

Result<void> TruthExchange::State::open(Node& node, const Arena& arena) {
    const std::string root = "/truth/" + topicPart(arena) + "/";
    const auto publish = [&](std::unique_ptr<Publisher>& to, const std::string& leaf, const std::string& type,
                             const Qos& qos, Flow flow = Flow::Telemetry) -> Result<void> {
        auto made = node.publisher({root + leaf, type, qos, flow});
        if (!made) return made.error();
        to = std::move(made).value();
        return {};
    };
    if (auto made = publish(poses, kind, "nav_msgs/msg/Odometry", Poses); !made) return made;
    allVictims = victimsOf(arena, {});
    if (auto made = publish(victims, "victims", std::string(typeOf(Sample(allVictims))), Lasting); !made)
        return made;
    if (auto made = publish(contacts, "contacts", std::string(typeOf(Sample(bumps))), Lasting); !made)
        return made;
    if (auto made = publish(labels, name + "/labels", "sensor_msgs/msg/Image", AllLabels, Flow::Scans); !made)
        return made;
    for (const std::string one : {"kurt3d", "crawler"}) {
        const StreamDescription stream = odometryOn(root + one);
        auto made = node.subscribe(
            {stream.topic, stream.type, stream.qos, Lane::Small},
            [this, one, stream](const ReceivedSample& sample) { receive(one, stream, sample); });
        if (!made) return made.error();
        subscriptions.push_back(std::move(made).value());
    }
    return {};
}

void TruthExchange::State::receive(const std::string& from, const StreamDescription& stream,
                                   const ReceivedSample& sample) {
    const auto decoded = decode(sample.event, stream);
    const auto* pose = decoded ? decoded->as<OdometrySample>() : nullptr;
    if (pose == nullptr || pose->header.frame != Frame) return;
    const std::string who = pose->childFrame.substr(0, pose->childFrame.find('/'));
    const std::lock_guard lock(mutex);
    if (who == name || (others.size() >= MostGhosts && !others.contains(who))) return;
    others[who] = {from, pose->baseInOdom, sample.event.received, true};
}

TruthExchange::TruthExchange(std::unique_ptr<State> state) : m_state(std::move(state)) {}

TruthExchange::~TruthExchange() {
    m_state->subscriptions.clear();
}

Result<std::unique_ptr<TruthExchange>> TruthExchange::create(Node& node, const Arena& arena,
                                                             const std::string& kind,
                                                             const RobotDescription& robot, int number) {
    auto state = std::make_unique<State>(robot, number);
    state->kind = kind;
    if (auto opened = state->open(node, arena); !opened) return opened.error();
    return std::unique_ptr<TruthExchange>(new TruthExchange(std::move(state)));
}

void TruthExchange::take(World& world) {
    const Time now = std::chrono::system_clock::now();
    const std::lock_guard lock(m_state->mutex);
    for (auto& [name, others] : m_state->others) {
        auto found = m_state->ghosts.find(name);
        if (others.fresh) {
            others.fresh = false;
            if (found == m_state->ghosts.end()) {
                BodySpec body = others.kind == "kurt3d" ? kurt3dBody() : crawlerBody();
                body.name = name;
                found = m_state->ghosts.emplace(name, State::Ghost{world.addGhost(body)}).first;
            }
            found->second.there = true;
            world.placeGhost(found->second.number, others.baseInArena);
        } else if (found != m_state->ghosts.end() && found->second.there && now - others.at > Forgotten) {
            // The ghost's process ended: moves it out of everybody's way.
            Pose away = Pose::Identity();
            away.translation() = Eigen::Vector3d(0.0, 0.0, -100.0);
            found->second.there = false;
            world.placeGhost(found->second.number, away);
        }
    }
}

void TruthExchange::publishLabels(const World& world, const CloudSample& cloud) {
    if (m_state->labels->matched() > 0) write(*m_state->labels, m_state->pointLabels.of(cloud, world));
}

void TruthExchange::publishTruth(const World& world) {
    if (!m_state->victimsPublished) {
        m_state->victimsPublished = true;
        m_state->allVictims.header.stamp = world.now();
        write(*m_state->victims, m_state->allVictims);
    }
    const auto& bumps = world.bumps();
    for (; m_state->bumpsSeen < bumps.size(); ++m_state->bumpsSeen) {
        const Bump& bump = bumps[m_state->bumpsSeen];
        if (bump.robot != m_state->robot) continue;
        const std::string met = (bump.victim ? "victim " : "area ") + bump.element;
        auto& all = m_state->bumps.bumpers;
        auto found = std::find_if(all.begin(), all.end(), [&](const Bumper& one) { return one.name == met; });
        if (found == all.end()) found = all.insert(all.end(), Bumper{met, true, 0});
        ++found->hits;
        m_state->bumps.header = {bump.at, m_state->name + "/base_link"};
        write(*m_state->contacts, m_state->bumps);
    }
    if (world.now() - m_state->published < Period) return;
    m_state->published = world.now();
    const BodyState& state = world.state(m_state->robot);
    OdometrySample pose;
    pose.header = {world.now(), Frame};
    pose.childFrame = m_state->name + "/base_link";
    pose.baseInOdom = state.baseInArena;
    pose.linear = state.linear;
    pose.angular = state.angular;
    write(*m_state->poses, pose);
}

}  // namespace leitstand::simulation
