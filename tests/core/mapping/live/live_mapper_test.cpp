#include "core/mapping/live/live_mapper.h"

#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/live/scan_doubts.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

const Pose Begin = poseFrom({-1.4, 0, 0.9}, 0, 0, 0);
const Pose Off = poseFrom({0.9, -0.7, 0}, 0, 0, degrees(25));  ///< so wrong is odometry that slipped

TEST(LiveMapper, TheFirstScanMakesTheMapLevelAndLooksAhead) {
    MappedRoom room;
    const Pose tilted = Begin * poseFrom({0, 0, 0}, degrees(4), degrees(-9), degrees(120));
    const MapUpdate update = room.add(tilted);
    ASSERT_TRUE(update.keyScan && update.poses);
    EXPECT_EQ(update.keyScan->id, 1U);
    const Pose& inMap = update.keyScan->scanInMap;
    EXPECT_LT(inMap.translation().norm(), 1e-9);
    EXPECT_TRUE((inMap.linear() * (tilted.linear().transpose() * Eigen::Vector3d::UnitZ()))
                    .isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
    EXPECT_NEAR(inMap.linear().col(0).y(), 0.0, 0.02) << "its heading is the map's";
    const MapUpdate next = room.add(Begin * poseFrom({0.4, 0, 0}, 0, 0, degrees(120)));
    EXPECT_EQ(next.localisation.doubts, 0) << inWords(next.localisation.doubts);
    EXPECT_LT(inDegrees(std::acos(next.localisation.baseInMap.linear()(2, 2))), 0.5);
}

TEST(LiveMapper, ADriveIsMappedToItsTruePosesAndAStandingRobotAddsNothing) {
    MappedRoom room;
    room.drive(6);
    const auto poses = room.poses();
    ASSERT_EQ(poses.size(), 6U);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const double step = static_cast<double>(i);
        const Pose truth =
            Begin.inverse() * poseFrom({-1.4 + 0.4 * step, 0.05 * step, 0.9}, 0, 0, degrees(3) * step);
        EXPECT_LT(distanceBetween(poses[i].scanInMap, truth), 0.02) << i;
        EXPECT_LT(inDegrees(angleBetween(poses[i].scanInMap, truth)), 0.3) << i;
        EXPECT_EQ(poses[i].trust, ScanTrust::Certain);
        EXPECT_TRUE(i == 0 || poses[i].overlap > 0.6) << i;
    }
    for (int i = 0; i < 3; ++i) {
        const MapUpdate update = room.add(room.last);
        EXPECT_FALSE(update.keyScan || update.poses);
        EXPECT_EQ(update.localisation.doubts, 0);
    }
    EXPECT_EQ(room.mapper.map()->scans.size(), 6U);
    EXPECT_TRUE(room.add(room.last * poseFrom({0, 0, 0}, 0, 0, degrees(12))).keyScan) << "turned";
}

TEST(LiveMapper, AScanWhoseMotionIsGuessedSaysSoInTheLogAndFitsAllTheSame) {
    MappedRoom room;
    room.add(scanAt(Begin, 1));
    LiveScan late = scanAt(Begin * poseFrom({0.4, 0, 0}, 0, 0, 0), 2);
    late.extrapolated = true;
    late.guessed = 0.02;
    const MapUpdate update = room.add(late);
    ASSERT_TRUE(update.keyScan && update.poses);
    EXPECT_EQ(update.localisation.trust, ScanTrust::Certain) << inWords(update.localisation.doubts);
    EXPECT_EQ(update.localisation.doubts, 0);
    const auto of = [](const std::vector<ScanPose>& poses) { return poses.back(); };
    constexpr auto Guessed = static_cast<std::uint8_t>(ScanDoubt::Guessed);
    EXPECT_EQ(of(room.poses()).doubts, Guessed);
    EXPECT_EQ(of(room.poses()).trust, ScanTrust::Certain);
    EXPECT_EQ(of(room.log.poses()).doubts, Guessed) << "the log tells it, too";
    EXPECT_EQ(room.poses().front().doubts, 0);
}

TEST(LiveMapper, AnotherRobotsBodyStaysInNoScan) {
    const RobotBody crawler{{{0.20, 0.13}, {-0.20, 0.13}, {-0.20, -0.13}, {0.20, -0.13}}, 0.35};
    const Pose sensor = Begin * poseFrom({0.4, 0, 0}, 0, 0, 0);
    // It stood 1.5 m ahead, then half a metre on.
    std::vector<Eigen::Vector3d> shell, floor;
    const Pose there = poseFrom({0.5, 0.3, 0}, 0, 0, degrees(30)),
               on = there * poseFrom({0.5, 0, 0}, 0, 0, 0);
    for (const Pose& place : {there, on}) {
        for (double x = -0.2; x < 0.21; x += 0.02) {
            for (double z = 0.07; z < 0.35; z += 0.02) shell.push_back(place * Eigen::Vector3d(x, -0.13, z));
            floor.push_back(place * Eigen::Vector3d(x, 0, 0.01));
        }
    }
    const auto kept = [&](const std::vector<PlacedBody>& others) {
        MappedRoom room;
        room.add(Begin);
        LiveScan live = scanAt(sensor, 2);
        Scan scan = *live.scan;
        scan.rows = scan.columns = 0;
        for (const auto* of : {&shell, &floor}) {
            for (const Eigen::Vector3d& point : *of)
                scan.points.push_back((sensor.inverse() * point).cast<float>());
        }
        live.scan = std::make_shared<const Scan>(std::move(scan));
        const MapUpdate update = room.mapper.add(live, room.now, others);
        EXPECT_TRUE(update.keyScan);
        std::pair<int, int> counted;  // on the body, on the floor below
        for (const Eigen::Vector3f& point : update.keyScan->scan->points) {
            for (const Pose& place : {there, on}) {
                const Eigen::Vector3d inBase = place.inverse() * (sensor * point.cast<double>());
                if (std::abs(inBase.x()) > 0.22 || std::abs(inBase.y()) > 0.15 || inBase.z() > 0.35) continue;
                ++(inBase.z() > 0.05 ? counted.first : counted.second);
            }
        }
        return counted;
    };
    const Pose& mapInRoom = Begin;  // the first scan makes the map, and is level
    const auto all = kept({});
    const auto clean = kept({{crawler, mapInRoom.inverse() * there}, {crawler, mapInRoom.inverse() * on}});
    EXPECT_GT(all.first, 200);
    EXPECT_EQ(clean.first, 0);
    EXPECT_EQ(clean.second, all.second) << "the floor stays";
    EXPECT_GT(clean.second, 20);
}

TEST(LiveMapper, AScanThatDoesNotFitIsUncertainAndNothingIsBuiltOnIt) {
    MappedRoom room;
    room.drive(4);
    const MapUpdate wrong = room.add(poseFrom({0.2, 0.15, 0.9}, 0, 0, degrees(12)), Off);
    EXPECT_EQ(wrong.localisation.trust, ScanTrust::Uncertain);
    EXPECT_NE(wrong.localisation.doubts, 0);
    ASSERT_TRUE(wrong.poses);
    EXPECT_EQ(wrong.poses->poses[0].trust, ScanTrust::Uncertain);
    EXPECT_TRUE(wrong.keyScan->scanInMap.isApprox(wrong.localisation.guessInMap)) << "where odometry says";
    EXPECT_TRUE(alike(room.poses(), room.log.poses()));
}

TEST(LiveMapper, OdometryMayBeWrongByAShareOfItsWayToAndFro) {
    for (const double way : {0.4, 1.2}) {
        MappedRoom room;
        room.drive(3);
        LiveScan scan =
            scanAt(poseFrom({-0.2, 0.15, 0.9}, 0, 0, degrees(9)), 30, poseFrom({0, 0.38, 0}, 0, 0, 0));
        scan.way = way;
        const auto doubts = room.add(scan).localisation.doubts;
        EXPECT_EQ(doubts, way < 1.0 ? static_cast<int>(ScanDoubt::Jump) : 0) << inWords(doubts);
    }
}

TEST(LiveMapper, ARobotWhoseWheelsSpinStaysWhereItStands) {
    MappedRoom room;
    room.drive(4);
    const Pose stands = room.last;
    // Against a wall that its scanner does not see: by odometry it drives on, 0.3 m a turn.
    for (int turn = 1; turn <= 10; ++turn) {
        const MapUpdate update = room.add(
            stands, Pose(Eigen::Translation3d(stands.linear() * Eigen::Vector3d(0.3 * turn, 0.0, 0.0))));
        EXPECT_EQ(update.localisation.trust, ScanTrust::Certain) << turn;
        EXPECT_LT(distanceBetween(update.scanInMap, room.poses().back().scanInMap), 0.05) << turn;
    }
    EXPECT_EQ(room.poses().size(), 4U) << "it adds nothing";
}

TEST(LiveMapper, TurnsThatAreBentByWheelsThatSpinShowThatTheRobotStands) {
    MappedRoom room;
    room.drive(4);
    const Pose stands = room.last;
    constexpr double Way = 0.6;  // a turn, by odometry
    for (int turn = 1; turn <= 6; ++turn) {
        LiveScan live = scanAt(stands, room.seed++, Pose(Eigen::Translation3d(Way * turn, 0.0, 0.0)));
        Scan scan = *live.scan;
        scan.start = scan.end - std::chrono::seconds(2);
        // Put together as if the robot had come along as its wheels did.
        for (int row = 0; row < scan.rows; ++row) {
            const double left = 1.0 - static_cast<double>(row) / (scan.rows - 1);
            for (int column = 0; column < scan.columns; ++column)
                scan.points[static_cast<std::size_t>(row) * scan.columns + column].x() -=
                    static_cast<float>(left * Way);
        }
        live.scan = std::make_shared<const Scan>(std::move(scan));
        live.motionKnown = true;
        live.velocity = {Way / 2.0, 0.0};
        live.way = Way;
        const MapUpdate update = room.add(live);
        EXPECT_EQ(update.localisation.trust, ScanTrust::Certain)
            << turn << ": " << inWords(update.localisation.doubts);
        EXPECT_LT(distanceBetween(update.scanInMap, room.poses().back().scanInMap), 0.03) << turn;
        const RobotFix fix = *room.mapper.fix("kurt3d");
        EXPECT_EQ(fix.doubts, 0) << turn;
    }
    EXPECT_EQ(room.poses().size(), 4U) << "it adds nothing";
}

TEST(LiveMapper, WhatWheelsSpunCountsNeitherForLinksNorAfterADecision) {
    MappedRoom room;
    room.drive(4);
    const Pose stands = room.last;
    const Eigen::Vector3d ahead = stands.linear().col(0);
    Pose drift = Pose::Identity();
    for (int turn = 1; turn <= 10; ++turn) {
        drift = Pose(Eigen::Translation3d(0.3 * turn * ahead));
        room.add(stands, drift);
        const RobotFix fix = *room.mapper.fix("kurt3d");
        EXPECT_NEAR(fix.spinningAt(fix.stamp + std::chrono::seconds(2)), 0.3 * turn, 0.05);
        EXPECT_EQ(fix.spinningAt(fix.stamp + std::chrono::seconds(7)), 0.0) << "its scanner is silent";
    }
    const Pose back = Eigen::Translation3d(-0.5 * ahead) * stands;
    const MapUpdate update = room.add(back, drift);
    ASSERT_TRUE(update.keyScan);
    ASSERT_TRUE(update.links);
    for (const Link& link : update.links->links) {
        if (link.kind != LinkKind::Odometry) continue;
        EXPECT_NEAR(link.pose.translation().norm(), 0.5, 0.1);
    }
    // Without its newest scan the robot goes on from the one before, by its odometry since.
    const Pose here = room.mapper.fix("kurt3d")->baseInMap;
    const auto decision = room.mapper.reject(update.keyScan->id, room.now);
    ASSERT_TRUE(decision);
    EXPECT_LT(distanceBetween(room.mapper.fix("kurt3d")->baseInMap, here), 0.1);
    EXPECT_EQ(room.add(back, drift).localisation.doubts, 0);
    EXPECT_EQ(room.mapper.fix("kurt3d")->spinning, 0.0) << "they stand";
}

TEST(LiveMapper, ARobotThatCameFartherThanItsWheelsIsDoubted) {
    MappedRoom room;
    room.drive(4);
    const Eigen::Vector3d ahead = room.last.linear().col(0);
    const Pose comes = Eigen::Translation3d(0.7 * ahead) * room.last;
    const MapUpdate update = room.add(comes, Pose(Eigen::Translation3d(-0.4 * ahead)));
    EXPECT_EQ(update.localisation.doubts, static_cast<int>(ScanDoubt::Jump)) << "wheels do not do that";
}

TEST(LiveMapper, DecisionsAreSamplesThatCanBeTakenBack) {
    MappedRoom room;
    room.drive(4);
    room.add(poseFrom({0.2, 0.15, 0.9}, 0, 0, degrees(12)), Off);
    const std::uint64_t id = room.poses().back().scan;
    const auto before = room.poses();
    ASSERT_EQ(before.back().trust, ScanTrust::Uncertain);
    const auto takenBack = [&](const Result<ScanPosesSample>& decision) {
        ASSERT_TRUE(decision);
        EXPECT_EQ(decision->cause, ScanPosesSample::Cause::Operator);
        const std::uint64_t reported = room.log.publish(*decision);
        const auto after = room.poses();
        EXPECT_FALSE(alike(after, before));
        EXPECT_TRUE(alike(after, room.log.poses()));
        const std::uint64_t undone = room.log.undo(reported, room.mapper);
        EXPECT_TRUE(alike(room.poses(), before));
        const std::uint64_t again = room.log.undo(undone, room.mapper);  // redo
        EXPECT_TRUE(alike(room.poses(), after));
        room.log.undo(again, room.mapper);
        EXPECT_TRUE(alike(room.poses(), before));
    };
    takenBack(room.mapper.accept(id, room.now));
    takenBack(room.mapper.reject(id, room.now));
    RetrySettings there;
    there.guessInMap = Begin.inverse() * poseFrom({0.0, 0.0, 0.9}, 0, 0, degrees(8));
    takenBack(room.mapper.retry(id, there, room.now));
    takenBack(room.mapper.rewind(room.now - std::chrono::seconds(5), room.now));
    EXPECT_FALSE(room.mapper.accept(99, room.now));
    EXPECT_THAT(room.mapper.reject(99, room.now).error().text, HasSubstr("key scan 99"));
}

TEST(LiveMapper, ARetryFromTheRightPlaceBringsTheRobotBack) {
    MappedRoom room;
    room.drive(4);
    const Pose place = poseFrom({0.2, 0.15, 0.9}, 0, 0, degrees(12));
    room.add(place, Off);
    RetrySettings there;
    there.guessInMap = Begin.inverse() * poseFrom({0.4, 0.0, 0.9}, 0, 0, degrees(5));
    const auto decision = room.mapper.retry(room.poses().back().scan, there, room.now);
    ASSERT_TRUE(decision);
    EXPECT_EQ(decision->poses[0].trust, ScanTrust::Certain) << inWords(decision->poses[0].doubts);
    EXPECT_LT(distanceBetween(decision->poses[0].scanInMap, Begin.inverse() * place), 0.03);
    const Pose next = place * poseFrom({0.4, 0, 0}, 0, 0, 0);
    const MapUpdate update = room.add(next, Off);
    EXPECT_EQ(update.localisation.doubts, 0) << inWords(update.localisation.doubts);
    EXPECT_LT(distanceBetween(update.localisation.baseInMap, Begin.inverse() * next), 0.03);
}

TEST(LiveMapper, AfterARewindTheRobotGoesOnFromWhatIsLeft) {
    MappedRoom room;
    room.drive(3);
    const Time moment = room.now;
    room.add(poseFrom({-0.2, 0.1, 0.9}, 0, 0, degrees(9)), Off);
    room.add(poseFrom({0.2, 0.15, 0.9}, 0, 0, degrees(12)), Off);
    const auto decision = room.mapper.rewind(moment, room.now);
    ASSERT_TRUE(decision);
    EXPECT_EQ(decision->poses.size(), 2U);
    for (const ScanPose& pose : decision->poses) EXPECT_EQ(pose.trust, ScanTrust::SetAside);
    EXPECT_FALSE(room.mapper.rewind(moment, room.now)) << "nothing is left to set aside";
    // Driven back to the last scan that counts, with odometry that knows the way from there.
    const MapUpdate update = room.add(poseFrom({-0.4, 0.1, 0.9}, 0, 0, degrees(6)));
    EXPECT_EQ(update.localisation.doubts, 0) << inWords(update.localisation.doubts);
}

TEST(LiveMapper, ARewindToOneOfSeveralScansThatCameAtOnceSetsAsideThoseAfterIt) {
    MappedRoom room;
    for (int i = 0; i < 4; ++i)  // after a radio gap
        room.log.publish(
            room.mapper.add(scanAt(Begin * poseFrom({0.4 * i, 0, 0}, 0, 0, 0), 1U + unsigned(i)), room.now));
    ASSERT_EQ(room.poses().size(), 4U);
    LiveMapper again = room.log.readAgain();
    for (LiveMapper* mapper : {&room.mapper, &again}) {
        ASSERT_TRUE(mapper->rewind(mapper->map()->scans[1].entered, room.now));
        const LiveMapPtr map = mapper->map();
        for (const LiveKeyScan& scan : map->scans)
            EXPECT_EQ(scan.pose.trust, scan.id <= 2 ? ScanTrust::Certain : ScanTrust::SetAside) << scan.id;
    }
}

TEST(LiveMapper, TheMapComesAgainFromTheLog) {
    MappedRoom room;
    room.drive(5);
    room.add(poseFrom({0.6, 0.2, 0.9}, 0, 0, degrees(15)), Off);
    room.log.publish(room.mapper.reject(2, room.now).value());
    LiveMapper again = room.log.readAgain();
    std::vector<ScanPose> poses;
    const LiveMapPtr map = again.map();
    for (const LiveKeyScan& scan : map->scans) poses.push_back(scan.pose);
    EXPECT_TRUE(alike(poses, room.poses()));
    ASSERT_EQ(again.map()->scans.size(), room.mapper.map()->scans.size());
    EXPECT_GT(poses[1].overlap, 0.5);
    const LiveMapPtr was = room.mapper.map();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const ScanPose& before = was->scans[i].pose;
        EXPECT_EQ(std::tie(poses[i].overlap, poses[i].rms, poses[i].inlierRatio, poses[i].certainty),
                  std::tie(before.overlap, before.rms, before.inlierRatio, before.certainty));
        EXPECT_EQ(poses[i].doubts, before.doubts);
    }
    EXPECT_EQ(again.map()->scans[0].scan, room.mapper.map()->scans[0].scan);
    // It goes on: the next scan gets the next number.
    EXPECT_TRUE(again.reject(6, room.now));
    const Pose next = poseFrom({0.55, 0.2, 0.9}, 0, 0, degrees(14));
    const MapUpdate update = again.add(scanAt(next, 50), room.now);
    EXPECT_EQ(update.localisation.doubts, 0) << inWords(update.localisation.doubts);
    EXPECT_LT(distanceBetween(update.localisation.baseInMap, Begin.inverse() * next), 0.03);
    ASSERT_TRUE(update.keyScan);
    EXPECT_EQ(update.keyScan->id, 7U);
}

TEST(LiveMapper, ASecondRobotEntersWhereItIsPlaced) {
    MappedRoom room;
    room.drive(4);
    const auto crawlerAt = [&](const Pose& sensorInRoom) {
        LiveScan live = scanAt(sensorInRoom, 70);
        Scan scan = *live.scan;
        scan.robot = "crawler";
        scan.sensorInOdom = Pose::Identity();
        live.scan = std::make_shared<const Scan>(std::move(scan));
        return live;
    };
    const Pose there = poseFrom({-0.9, 0.3, 0.5}, 0, 0, degrees(40));
    const MapUpdate nowhere = room.add(crawlerAt(there));
    EXPECT_FALSE(nowhere.keyScan);
    EXPECT_TRUE(has(nowhere.localisation.doubts, ScanDoubt::Odometry));
    room.mapper.place("crawler", Begin.inverse() * there * poseFrom({0.3, -0.2, 0}, 0, 0, degrees(8)));
    const MapUpdate placed = room.add(crawlerAt(there));
    EXPECT_EQ(placed.localisation.doubts, 0) << inWords(placed.localisation.doubts);
    EXPECT_LT(distanceBetween(placed.localisation.baseInMap, Begin.inverse() * there), 0.03);
}

LiveScan corridorScan(double x, unsigned seed, bool odometry = true) {
    RoomSettings settings;
    settings.sensorInRoom = poseFrom({x, 0, 0.9}, 0, 0, 0);
    settings.sweep = Sweep::Yawing;
    settings.rows = 121;
    settings.columns = 81;
    settings.length = 60.0;
    settings.seed = seed;
    Scan made = scanCorridor(settings).scan;
    made.robot = "kurt3d";
    made.sensorInOdom = settings.sensorInRoom;
    made.hasOdometry = odometry;
    LiveScan live;
    live.scan = std::make_shared<const Scan>(std::move(made));
    return live;
}

TEST(LiveMapper, OdometryHoldsTheAxisOfAnOpenCorridor) {
    MappedRoom corridor;
    corridor.add(corridorScan(0.0, 1));
    for (int i = 1; i <= 10; ++i) {
        const MapUpdate update = corridor.add(corridorScan(0.5 * i, static_cast<unsigned>(i + 1)));
        EXPECT_EQ(update.localisation.doubts, 0) << inWords(update.localisation.doubts);
        EXPECT_GE(update.localisation.icp.open, 1);
        EXPECT_NEAR(update.localisation.baseInMap.translation().x(), 0.5 * i, 0.02 * i) << "odometry knows";
        EXPECT_NEAR(update.localisation.baseInMap.translation().y(), 0.0, 0.02) << "the walls know";
    }
}

TEST(LiveMapper, AnOpenCorridorLeavesADirectionOpenWhereNoOdometryHoldsIt) {
    MappedRoom corridor;
    corridor.add(corridorScan(0.0, 1));
    const MapUpdate update = corridor.add(corridorScan(0.5, 2, false));
    EXPECT_TRUE(has(update.localisation.doubts, ScanDoubt::Certainty)) << inWords(update.localisation.doubts);
}

TEST(LiveMapper, OdometryThatMayHaveDriftedTooFarHoldsNothing) {
    LiveSettings settings;
    settings.match.odometry.share = 0.1;  // 0.5 m in the last 5 m
    MappedRoom corridor;
    corridor.mapper = LiveMapper("station", settings);
    corridor.add(corridorScan(0.0, 1));
    std::uint8_t doubts = 0;
    for (int i = 1; i <= 10; ++i)
        doubts |= corridor.add(corridorScan(0.5 * i, static_cast<unsigned>(i + 1))).localisation.doubts;
    EXPECT_TRUE(has(doubts, ScanDoubt::Certainty)) << inWords(doubts);
}

TEST(ScanCleaning, TheRobotsBodyAndWhatIsCroppedAreLeftOut) {
    Scan scan;
    scan.points = {{0.1F, 0.0F, -0.1F},   // on the robot
                   {0.24F, 0.0F, -0.1F},  // within the margin of its front
                   {0.5F, 0.0F, -0.1F},   // before it
                   {0.0F, 0.0F, -0.48F},  // the ground below it
                   {0.0F, 0.0F, 1.0F},    // above it
                   {3.0F, 0.0F, 0.0F}};   // a spectator
    const Pose sensorInBase = poseFrom({0, 0, 0.48}, 0, 0, 0);
    const RobotBody body{{{0.225, 0.165}, {-0.225, 0.165}, {-0.225, -0.165}, {0.225, -0.165}}, 0.65};
    leaveOutBody(scan, body, sensorInBase);
    const auto echoes = [&] {
        std::string text;
        for (const Eigen::Vector3f& point : scan.points) text += point.allFinite() ? 'x' : '.';
        return text;
    };
    EXPECT_EQ(echoes(), "..xxxx");
    MapCrop crop;
    EXPECT_TRUE(crop.open());
    crop.polygon = {{-1, -1}, {2, -1}, {2, 1}, {-1, 1}};
    crop.ceiling = 0.8;
    leaveOutCropped(scan, crop, Pose::Identity());
    EXPECT_EQ(echoes(), "..xx..");
    leaveOutCropped(scan, crop, poseFrom({1.7, 0, 0}, 0, 0, 0));
    EXPECT_EQ(echoes(), "...x..");
}

}  // namespace
}  // namespace leitstand::test
