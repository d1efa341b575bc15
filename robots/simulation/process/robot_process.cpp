#include "robots/simulation/process/robot_process.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>

#include "core/base/printable.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"
#include "core/robot/link/screen_report.h"
#include "core/robot/streams/stream_table.h"
#include "core/settings/ros_environment.h"
#include "robots/control/fuzzy/fuzzy_file.h"
#include "robots/crawler/crawler_agent.h"
#include "robots/kurt3d/kurt3d_agent.h"
#include "robots/simulation/process/choose_arena.h"
#include "robots/simulation/process/frozen_pictures.h"
#include "robots/simulation/process/pace.h"
#include "robots/simulation/process/truth_exchange.h"
#include "robots/simulation/simulated_hardware.h"
#include "robots/simulation/stock/stock_joints.h"
#include "robots/simulation/stock/stock_localisation.h"
#include "robots/simulation/stock/stock_navigation.h"
#include "robots/simulation/stock/stock_others.h"
#include "robots/simulation/stock/stock_profile.h"
#include "robots/simulation/stock/stock_services.h"
#include "robots/wire/robot_wire.h"
#include "transport/domain/join_settings.h"

namespace leitstand::simulation {
namespace {

/// Kurt3D's slices are 280 kB/s. On a link of 10 Mbit/s with 5 % loss, 240 kB/s pass at 7000 B in 20 ms, and
/// 435 kB/s in 10 ms. At 10 ms the robot catches up after a busy computer or a radio gap, and new subscribers
/// receive slices at once.
constexpr FlowLimit ScanLimit{.bytes = 7000, .milliseconds = 10};

volatile std::sig_atomic_t stopped = 0, frozen = 0;

Result<RobotDescription> describe(const RobotOptions& options) {
    if (options.stock != nullptr) return describe(*options.stock, options.nameSpace);
    const auto file = findRobotFile(options.file.empty() ? options.kind : options.file);
    if (!file) return file.error();
    auto robot = readRobot(*file);
    if (!robot || options.name.empty()) return robot;
    RobotDescription named = std::move(robot).value();
    const std::string before = "/" + named.name + "/";
    for (StreamDescription& stream : named.streams) {
        if (stream.topic.starts_with(before))
            stream.topic = "/" + options.name + "/" + stream.topic.substr(before.size());
        if (stream.hardwareId == named.name) stream.hardwareId = options.name;
    }
    named.name = named.title = options.name;
    // A name that no robot file may have is refused. The first error is about the name, the others are about
    // topics.
    if (const auto checked = parseRobot(writeRobot(named), "--name"); !checked) {
        const std::string& text = checked.error().text;
        const std::size_t begin = std::min(text.find("expected"), text.size());
        return Error{"--name: " + text.substr(begin, text.find('\n', begin) - begin)};
    }
    return named;
}

/// Returns how the robot's file moves the scanner of the stream of @p role; Unsaid when it does not state it.
SensorMotion motionOf(const RobotDescription& robot, StreamRole role) {
    const StreamDescription* stream = robot.stream(role);
    const auto sensor = robot.sensors.find(stream == nullptr ? std::string() : stream->sensor);
    return sensor == robot.sensors.end() ? SensorMotion::Unknown : sensor->second.motion;
}

Result<FuzzySystem> fuzzyRules() {
    for (const auto& robots : robotFolders()) {
        const auto file = robots.parent_path() / "control" / "fuzzy_drive.yaml";
        std::error_code problem;
        if (std::filesystem::exists(file, problem)) return readFuzzySystem(file);
    }
    return Error{"control/fuzzy_drive.yaml: not found beside the robots' files"};
}

template <class Agent, class Settings>
Result<std::unique_ptr<RobotAgent>> make(const RobotOptions& options, RobotHardware& hardware,
                                         const RobotDescription& robot) {
    const auto rules = fuzzyRules();
    if (!rules) return rules.error();
    Settings settings;
    settings.agent.careless = options.careless || options.stock != nullptr;
    if (options.stock != nullptr) settings.agent.ownWatchdog = options.stock->watchdog;
    auto agent = Agent::create(hardware, robot, *rules, settings);
    if (!agent) return agent.error();
    return std::unique_ptr<RobotAgent>(std::move(agent).value());
}

Result<std::unique_ptr<RobotAgent>> agentFor(const RobotOptions& options, RobotHardware& hardware,
                                             const RobotDescription& robot) {
    if (options.kind == "crawler") return make<CrawlerAgent, CrawlerSettings>(options, hardware, robot);
    return make<Kurt3dAgent, Kurt3dSettings>(options, hardware, robot);
}

Result<std::unique_ptr<Node>> join(const DomainSettings& domain, const std::string& name,
                                   bool stock = false) {
    auto made = nodeSettings(domain, name);
    if (!made) return made.error();
    NodeSettings network = std::move(made).value();
    network.scanLimit = ScanLimit;
    // Drivers of others send as fast as they can.
    if (stock) network.telemetryLimit.bytes = network.scanLimit.bytes = network.pictureLimit.bytes = 0;
    return Node::create(network);
}

Result<DomainSettings> domainOf(const RobotOptions& options) {
    const auto environment = rosEnvironment();
    if (!environment) return environment.error();
    auto domain = domainSettings(options.network, *environment);
    if (domain && domain->domain > LastDomain)
        return Error{fmt::format("domain: expected 0 to {}, since the truth is on the one {} above, found {}",
                                 LastDomain, TruthAbove, domain->domain)};
    return domain;
}

/// A robot's world, its agent, its two ends of the network and its cameras.
struct Life {
    World& world;
    RobotAgent& agent;
    RobotWire& wire;
    StockOthers& others;
    const StockServices& services;
    StockNavigation* navigation;  ///< null: the robot has none
    StockLocalisation& localisation;
    StockJoints& joints;
    TruthExchange& truth;
    FrozenPictures& cameras;
    double gravity;  ///< unit of accelerations that it reports [m/s2]
};

void turn(const Life& life) {
    auto& [world, agent, wire, others, services, navigation, localisation, joints, truth, cameras, gravity] =
        life;
    truth.take(world);
    world.advance(Pace::Step);
    for (const ReceivedCommand& command : wire.take()) {
        if (const auto* grant = command.sample.as<GrantSample>()) {
            agent.receive(*grant, command.from);
        } else if (command.role == StreamRole::JointCommand) {
            joints.receive(command.group, command.sample);
        } else if (!services.motorsAreOff() || command.role != StreamRole::DriveCommand) {
            agent.receive(command.role, command.sample, command.from);
        }
    }
    if (services.motorsAreOff()) agent.receive(StreamRole::DriveCommand, TwistSample{}, {});
    std::vector<HardwareSample> samples = agent.step();
    if (navigation != nullptr) {
        const auto command = navigation->step(world.now(), samples);
        if (command && !services.motorsAreOff()) agent.receive(StreamRole::DriveCommand, *command, {});
    }
    joints.step(world.now(), !services.motorsAreOff());
    for (HardwareSample& added : localisation.step(world, samples)) samples.push_back(std::move(added));
    for (HardwareSample& sample : samples) {
        if (services.camerasAreOff() && streamFacts(sample.role).picture) continue;
        cameras.pass(sample, frozen != 0);
        if (auto* const said = sample.sample.edit<JointSample>()) joints.addTo(*said);
        auto* const imu = gravity == 1.0 ? nullptr : sample.sample.edit<ImuSample>();
        if (imu != nullptr && imu->linearAcceleration) *imu->linearAcceleration /= gravity;
        wire.publish(sample);
        if (const auto* cloud = sample.sample.as<CloudSample>()) truth.publishLabels(world, *cloud);
    }
    others.publish(world.now());
    truth.publishTruth(world);
}

/// Requests the robot to end; the system ends it when a library hangs.
void end(int /*signal*/) {
    constexpr unsigned AtMost = 4;  // [s]
    stopped = 1;
    alarm(AtMost);
}

void live(const Life& life, Pace& pace) {
    pace.begin(Pace::Clock::now());
    while (stopped == 0) {
        while (stopped == 0 && pace.step(Pace::Clock::now())) turn(life);
        std::this_thread::sleep_until(pace.next());
    }
}

}  // namespace

Result<void> runRobot(const RobotOptions& options) {
    const auto arena = chooseArena(options.arena, options.seed, options.building);
    if (!arena) return arena.error();
    const auto robot = describe(options);
    if (!robot) return robot.error();
    auto start = arena->starts.find(robot->name);
    if (start == arena->starts.end()) start = arena->starts.find(options.kind);
    if (start == arena->starts.end())
        return Error{fmt::format("{}: expected a start of {}, found none", arena->name, options.kind)};
    World world(*arena, options.seed, std::chrono::system_clock::now());
    BodySpec body = options.kind == "kurt3d" ? kurt3dBody() : crawlerBody();
    body.name = robot->name;
    const int number = world.addRobot(body, start->second);
    Pace pace;
    HardwareSettings fitting;
    fitting.mayDraw = [&pace](std::string_view camera) { return pace.mayDraw(camera, Pace::Clock::now()); };
    fitting.seed = options.seed;
    const bool tilting = options.tilting || motionOf(*robot, StreamRole::Points) == SensorMotion::Tilting;
    fitting.scanner = tilting ? ScannerMount::Tilting : ScannerMount::ScanDrive;
    fitting.turningLaser =
        options.turningLaser || motionOf(*robot, StreamRole::Ranges) == SensorMotion::Turning;
    if (options.stock != nullptr) {
        fitting.lidar = options.stock->lidar();
        fitting.lidarMountTold = options.stock->mountTold;
    }
    const auto hardware = options.stock != nullptr   ? makeStockHardware(world, number, *robot, fitting)
                          : options.kind == "kurt3d" ? makeKurt3dHardware(world, number, *robot, fitting)
                                                     : makeCrawlerHardware(world, number, *robot, fitting);
    const auto agent = agentFor(options, *hardware, *robot);
    if (!agent) return agent.error();
    ScreenMessages publishing;
    auto domain = domainOf(options);
    if (!domain) return domain.error();
    if (const std::string by = environmentLine(*domain); !by.empty())
        std::fprintf(stderr, "%s\n", printable(by).c_str());
    const auto node = join(*domain, robot->name, options.stock != nullptr);
    if (!node) return node.error();
    for (const std::string& warning : (*node)->warnings())
        std::fprintf(stderr, "%s\n", printable(warning).c_str());
    (*node)->onDiscovery([&publishing, raw = node->get()] {
        for (const ScreenDrop& drop : publishing.due(raw->dropped()))
            std::fprintf(stderr, "%s\n", printable(toString(drop)).c_str());
    });
    DomainSettings beside = *domain;
    beside.domain += TruthAbove;
    beside.keys.clear();
    const auto truths = join(beside, robot->name + " truth");
    if (!truths) return truths.error();
    const auto wire = RobotWire::create(
        **node, *robot, options.stock != nullptr ? RobotWire::Grants::Unknown : RobotWire::Grants::Obeyed);
    if (!wire) return wire.error();
    StockOthers others;
    if (options.stock != nullptr) {
        auto made = StockOthers::create(**node, *options.stock, options.nameSpace);
        if (!made) return made.error();
        others = std::move(made).value();
    }
    RobotDescription offering = *robot;
    if (options.stock == nullptr) offering.services.clear();  // ours have topics for it
    const auto services = StockServices::create(**node, offering);
    if (!services) return services.error();
    const auto navigation = StockNavigation::create(**node, offering);
    if (!navigation) return navigation.error();
    const auto truth = TruthExchange::create(**truths, *arena, options.kind, *robot, number);
    if (!truth) return truth.error();
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, end);
    std::signal(SIGUSR1, [](int) { frozen = frozen == 0 ? 1 : 0; });
    std::printf("%s is in %s on domain %d\n", printable(robot->name).c_str(), printable(arena->name).c_str(),
                domain->domain);
    std::fflush(stdout);
    FrozenPictures cameras;
    StockLocalisation localisation(world, number, *robot);
    StockJoints joints(*robot);
    live({world, **agent, **wire, others, **services, navigation->get(), localisation, joints, **truth,
          cameras, options.stock != nullptr ? options.stock->gravity : 1.0},
         pace);
    return {};
}

}  // namespace leitstand::simulation
