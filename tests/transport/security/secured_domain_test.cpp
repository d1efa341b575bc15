#include <array>
#include <functional>
#include <string_view>
#include <thread>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/event/stream_role.h"
#include "tests/support/dds/going_listeners.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"
#include "tests/transport/security/secured.h"
#include "transport/dds/node.h"
#include "transport/link/drive_guard.h"
#include "transport/link/grant_sender.h"
#include "transport/security/authorities.h"
#include "transport/security/enclave.h"
#include "transport/security/keys.h"
#include "transport/security/permissions.h"

namespace leitstand::test {
namespace {

/// Has all @p writers write again and again until @p condition holds.
bool writingUntil(const std::vector<Writer*>& writers, const std::function<bool()>& condition) {
    return waitUntil([&] {
        for (Writer* writer : writers) writer->write("x");
        return condition();
    });
}

/// A keystore of a team, and participants in a domain of the test's own.
class SecuredDomain : public ::testing::Test {
protected:
    SecuredDomain() {
        const auto made = createKeys(m_folder / "keys", {{KeyRole::Station, "station1", {}, false},
                                                         {KeyRole::Robot, "kurt3d", {}, false},
                                                         {KeyRole::Robot, "crawler", {}, false},
                                                         {KeyRole::Viewer, "coach", {}, false}});
        EXPECT_TRUE(made.ok()) << made.error().text;
    }

    [[nodiscard]] SecurityFiles filesOf(const std::string& name, const std::string& store = "keys") const {
        const auto files = securityFiles(m_folder / store / "enclaves" / name);
        EXPECT_TRUE(files.ok()) << files.error().text;
        return files.ok() ? *files : SecurityFiles{};
    }

    const TestDomain m_domain;
    const TemporaryFolder m_folder;
};

TEST_F(SecuredDomain, StationAndRobotTalk) {
    const Participant station(m_domain.number(), filesOf("station1")),
        robot(m_domain.number(), filesOf("kurt3d"));
    ASSERT_TRUE(station.joined() && robot.joined());
    Writer drive(station, "rt/kurt3d/cmd_vel"), odometry(robot, "rt/kurt3d/odom");
    const Reader driven(robot, "rt/kurt3d/cmd_vel"), seen(station, "rt/kurt3d/odom");
    ASSERT_TRUE(drive.allowed() && odometry.allowed() && driven.allowed() && seen.allowed());
    EXPECT_TRUE(writingUntil({&drive, &odometry}, [&] { return driven.samples() > 9 && seen.samples() > 9; }))
        << driven.samples() << " commands, " << seen.samples() << " samples";
}

TEST_F(SecuredDomain, AGuardWithTheKeysOfItsStationIsHeardByTheRobot) {
    const auto join = [&](const std::string& name) {
        NodeSettings settings;
        settings.domain = m_domain.number();
        settings.security = filesOf(name);
        return Node::create(settings).value();
    };
    const auto station = join("station1"), beside = join("station1"), robot = join("kurt3d");
    StreamDescription command;
    command.role = StreamRole::DriveCommand;
    command.topic = "/kurt3d/cmd_vel";
    command.type = "geometry_msgs/msg/Twist";
    std::atomic<int> zeros = 0;
    const auto driven = robot->subscribe({command.topic, command.type, command.qos, Lane::Small},
                                         [&](const ReceivedSample&) { ++zeros; });
    ASSERT_TRUE(driven.ok()) << driven.error().text;
    DriveGuardSettings settings;
    settings.robot = "kurt3d";
    settings.station = "a";
    settings.driver = senderOf(station->guid());
    settings.message.stream = command;
    const auto guard = DriveGuard::create(*beside, settings).value();
    std::array<int, 2> ends{};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()), 0);
    std::jthread serving([&] { guard->serve(ends[1]); });
    std::array<char, 16> word{};
    EXPECT_TRUE(waitUntil([&] {
        const ssize_t size = recv(ends[0], word.data(), word.size(), MSG_DONTWAIT);
        return size > 0 && std::string_view(word.data(), static_cast<std::size_t>(size)) == "ready";
    }));
    EXPECT_EQ(zeros, 0);
    EXPECT_GT(send(ends[0], "drive 0", 7, MSG_NOSIGNAL), 0);
    EXPECT_TRUE(waitUntil([&] { return zeros >= 5; }));
    close(ends[0]);
    serving.join();
    close(ends[1]);
}

TEST_F(SecuredDomain, OurNodesTakePart) {
    NodeSettings settings;
    settings.domain = m_domain.number();
    settings.security = filesOf("station1");
    const auto node = Node::create(settings);
    ASSERT_TRUE(node.ok()) << node.error().text;
    const Participant robot(m_domain.number(), filesOf("kurt3d"));
    ASSERT_TRUE(robot.joined());
    std::atomic<int> received = 0;
    const auto subscription = (*node)->subscribe({"/kurt3d/odom", "std_msgs/msg/String", {}, Lane::Small},
                                                 [&](const ReceivedSample&) { ++received; });
    ASSERT_TRUE(subscription.ok()) << subscription.error().text;
    Writer odometry(robot, "rt/kurt3d/odom");
    EXPECT_TRUE(writingUntil({&odometry}, [&] { return received > 9; })) << received << " samples";
    settings.security = filesOf("coach");
    const auto viewer = Node::create(settings);
    ASSERT_TRUE(viewer.ok()) << viewer.error().text;
    EXPECT_FALSE((*viewer)->publisher({"/kurt3d/cmd_vel", "std_msgs/msg/String", {}, Flow::Immediate}).ok());
}

TEST_F(SecuredDomain, WhoWritesOutlivesThatTheLastOneWhoHearsGoes) {
    NodeSettings settings;
    settings.domain = m_domain.number();
    settings.security = filesOf("kurt3d");
    const auto robot = Node::create(settings).value();
    settings.security = filesOf("station1");
    const auto station = Node::create(settings).value();
    for (const int depth : {1, 100}) expectOutlivesItsListeners(*robot, *station, 30, depth);
}

TEST_F(SecuredDomain, BigSamplesArriveWhole) {
    const Participant station(m_domain.number(), filesOf("station1")),
        robot(m_domain.number(), filesOf("kurt3d"));
    Writer points(robot, "rt/kurt3d/points");
    const Reader seen(station, "rt/kurt3d/points");
    ASSERT_TRUE(waitUntil([&] { return seen.matched() == 1 && points.matched() == 1; }));
    const std::string scan(500'000, 'p');
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 10; ++i) {
        points.write(scan);
        EXPECT_TRUE(waitUntil([&] { return seen.samples() > i; })) << i;
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    RecordProperty("milliseconds_per_scan", static_cast<int>(100 * took.count()));
}

/// Whoever is no member: two of them talk to each other, and neither hears nor commands the members.
void expectShutOut(int domain, const SecurityFiles& stationFiles, const SecurityFiles& robotFiles,
                   const std::optional<SecurityFiles>& strangerFiles,
                   const std::optional<SecurityFiles>& otherStrangerFiles) {
    const Participant station(domain, stationFiles), robot(domain, robotFiles);
    const Participant stranger(domain, strangerFiles), other(domain, otherStrangerFiles);
    ASSERT_TRUE(station.joined() && robot.joined() && stranger.joined() && other.joined());
    Writer odometry(robot, "rt/kurt3d/odom"), forgedDrive(stranger, "rt/kurt3d/cmd_vel"),
        forgedStop(stranger, "rt/kurt3d/stop_cmd"), forgedOdometry(other, "rt/kurt3d/odom");
    const Reader driven(robot, "rt/kurt3d/cmd_vel"), stopped(robot, "rt/kurt3d/stop_cmd"),
        seen(station, "rt/kurt3d/odom"), overheard(stranger, "rt/kurt3d/odom");
    ASSERT_TRUE(forgedDrive.allowed() && overheard.allowed());
    // Strangers find each other, so that they had their chance with the members too.
    ASSERT_TRUE(writingUntil({&odometry, &forgedDrive, &forgedStop, &forgedOdometry},
                             [&] { return seen.samples() > 40 && overheard.matched() == 1; }))
        << seen.samples() << " samples, " << overheard.matched() << " matched";
    EXPECT_EQ(driven.samples(), 0);
    EXPECT_EQ(stopped.samples(), 0);
    EXPECT_EQ(driven.matched(), 0);
    EXPECT_EQ(stopped.matched(), 0);
    EXPECT_EQ(seen.matched(), 1) << "only the robot is heard";
    EXPECT_EQ(odometry.matched(), 1) << "only the station hears";
}

TEST_F(SecuredDomain, UnsecuredParticipantsGetNothingAndCommandNobody) {
    expectShutOut(m_domain.number(), filesOf("station1"), filesOf("kurt3d"), {}, {});
}

TEST_F(SecuredDomain, ParticipantsOfAnotherAuthorityGetNothingAndCommandNobody) {
    ASSERT_TRUE(createKeys(m_folder / "foreign",
                           {{KeyRole::Station, "station1", {}, false}, {KeyRole::Robot, "kurt3d", {}, false}})
                    .ok());
    expectShutOut(m_domain.number(), filesOf("station1"), filesOf("kurt3d"), filesOf("station1", "foreign"),
                  filesOf("kurt3d", "foreign"));
}

TEST_F(SecuredDomain, AViewerReadsAndStopsButCannotDrive) {
    const Participant viewer(m_domain.number(), filesOf("coach")),
        robot(m_domain.number(), filesOf("kurt3d"));
    Writer odometry(robot, "rt/kurt3d/odom"), stop(viewer, "rt/kurt3d/stop_cmd");
    const Reader stopped(robot, "rt/kurt3d/stop_cmd"), seen(viewer, "rt/kurt3d/odom");
    ASSERT_TRUE(stop.allowed() && seen.allowed());
    EXPECT_TRUE(writingUntil({&odometry, &stop}, [&] { return seen.samples() > 0 && stopped.samples() > 0; }))
        << seen.samples() << " samples, " << stopped.samples() << " stops";
    EXPECT_FALSE(Writer(viewer, "rt/kurt3d/cmd_vel").allowed());
    EXPECT_FALSE(Writer(viewer, "rt/kurt3d/mode_cmd").allowed());
    EXPECT_FALSE(Writer(viewer, "rt/leitstand/grants").allowed());
}

TEST_F(SecuredDomain, AViewerWhoseOwnChecksAreOffCannotDriveEither) {
    // Stands for a library that was tampered with: rules that ask nobody, though signed as they must be.
    std::string rules = governanceXml();
    const std::string check = "<enable_write_access_control>true";
    for (auto at = rules.find(check); at != std::string::npos; at = rules.find(check)) {
        rules.replace(at, check.size(), "<enable_write_access_control>false");
    }
    const auto authorities = readAuthorities(KeystoreLayout{m_folder / "keys"});
    ASSERT_TRUE(authorities.ok()) << authorities.error().text;
    const auto text =
        openssl::signText(rules, authorities->permissionsCa.get(), authorities->permissionsKey.get());
    ASSERT_TRUE(text.ok()) << text.error().text;
    SecurityFiles tampered = filesOf("coach");
    tampered.governance = m_folder / "governance.p7s";
    writeText(tampered.governance, *text);

    const Participant viewer(m_domain.number(), tampered), robot(m_domain.number(), filesOf("kurt3d")),
        station(m_domain.number(), filesOf("station1"));
    ASSERT_TRUE(viewer.joined() && robot.joined() && station.joined());
    Writer forged(viewer, "rt/kurt3d/cmd_vel"), drive(station, "rt/kurt3d/cmd_vel");
    ASSERT_TRUE(forged.allowed()) << "its own library does not stop it";
    const Reader driven(robot, "rt/kurt3d/cmd_vel");
    EXPECT_TRUE(writingUntil({&drive, &forged}, [&] { return driven.samples() > 40; }));
    EXPECT_EQ(driven.matched(), 1) << "the station, not the viewer";
    EXPECT_EQ(forged.matched(), 0);
}

TEST_F(SecuredDomain, ARobotSpeaksForItselfOnly) {
    const Participant robot(m_domain.number(), filesOf("kurt3d"));
    EXPECT_TRUE(Writer(robot, "rt/kurt3d/left/image/compressed").allowed());
    EXPECT_TRUE(Writer(robot, "rt/tf_static").allowed());
    EXPECT_FALSE(Writer(robot, "rt/kurt3d/cmd_vel").allowed());
    EXPECT_FALSE(Writer(robot, "rt/crawler/odom").allowed());
    EXPECT_FALSE(Writer(robot, "rt/crawler/stop_cmd").allowed());
    EXPECT_FALSE(Writer(robot, "rt/leitstand/victims").allowed());
    EXPECT_TRUE(Reader(robot, "rt/leitstand/clock").allowed());
    EXPECT_FALSE(Reader(robot, "rt/crawler/points").allowed());
}

TEST_F(SecuredDomain, ExpiredAndRevokedIdentitiesAreRefused) {
    KeySettings past;
    past.now -= std::chrono::hours(24 * 400);
    const auto expired = createKeys(m_folder / "past", {{KeyRole::Robot, "old", {}, false}}, past);
    ASSERT_TRUE(expired.ok()) << expired.error().text;
    const auto files = securityFiles(m_folder / "past/enclaves/old", past.now);
    ASSERT_TRUE(files.ok()) << files.error().text;
    EXPECT_FALSE(Participant(m_domain.number(), *files).joined());

    const SecurityFiles stolen = filesOf("coach");
    std::filesystem::copy(stolen.certificate.parent_path(), m_folder / "stolen");
    ASSERT_TRUE(revokeKeys(m_folder / "keys", "coach").ok());
    const auto kept = securityFiles(m_folder / "stolen");  // the thief keeps the old list
    ASSERT_TRUE(kept.ok()) << kept.error().text;
    const Participant thief(m_domain.number(), *kept), robot(m_domain.number(), filesOf("kurt3d")),
        station(m_domain.number(), filesOf("station1"));
    ASSERT_TRUE(thief.joined() && robot.joined() && station.joined());
    Writer forgedStop(thief, "rt/kurt3d/stop_cmd"), stop(station, "rt/kurt3d/stop_cmd");
    const Reader stopped(robot, "rt/kurt3d/stop_cmd");
    EXPECT_TRUE(writingUntil({&stop, &forgedStop}, [&] { return stopped.samples() > 40; }));
    EXPECT_EQ(stopped.matched(), 1) << "the station, not the thief";
}

}  // namespace
}  // namespace leitstand::test
