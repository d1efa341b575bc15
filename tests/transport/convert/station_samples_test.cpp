#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/event/sample.h"
#include "messages/leitstand_msgs.h"
#include "messages/sensor_msgs.h"
#include "tests/transport/convert/conversion.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
namespace lm = wire::leitstand_msgs;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The error about the sample of that type in sampleCases() after @p change of its message; "none" when fine.
template <class Message, class Change>
std::string errorAfter(Change change) {
    for (const SampleCase& one : sampleCases()) {
        if (one.type != Message::RosName) continue;
        const auto bytes = encoded(one);
        CdrReader in(bytes);
        Message message;
        decode(in, message);
        change(message);
        CdrWriter out;
        encode(out, message);
        const auto sample = decodeCase(one, rawEvent(one, std::move(out).finish()));
        return sample ? "none" : sample.error().text;
    }
    return "no such sample";
}

TEST(KeyScans, FitTheirGridsAndLists) {
    const auto error = [](auto change) { return errorAfter<lm::KeyScan>(change); };
    const std::vector<std::byte> wrongLabels(4, std::byte{4}), fewLabels(3);
    EXPECT_EQ(error([](auto&) {}), "none");
    EXPECT_EQ(error([](auto& m) { m.rows = m.columns = 0; }), "none");
    EXPECT_EQ(error([](auto& m) { m.labels = {}, m.intensities = {}; }), "none");
    EXPECT_THAT(error([](auto& m) { m.rows = 3; }), HasSubstr("3 x 2 does not fit 4 points"));
    EXPECT_THAT(error([](auto& m) { m.rows = 4'000'000'000; }), HasSubstr("rows"));
    EXPECT_THAT(error([](auto& m) { m.points.pop_back(); }), HasSubstr("three numbers a point"));
    EXPECT_THAT(error([](auto& m) { m.intensities.pop_back(); }), HasSubstr("intensities"));
    EXPECT_THAT(error([&](auto& m) { m.labels = fewLabels; }), HasSubstr("labels"));
    EXPECT_THAT(error([&](auto& m) { m.labels = wrongLabels; }), HasSubstr("labels"));
    EXPECT_THAT(error([](auto& m) { m.sweep = 2; }), HasSubstr("sweep"));
    EXPECT_THAT(error([](auto& m) { m.id = 0; }), HasSubstr("id"));
    EXPECT_THAT(error([](auto& m) { m.scan_in_map.position.x = NaN; }), HasSubstr("scan_in_map"));
}

TEST(ScanPoses, AreRigidAndOfScans) {
    const auto error = [](auto change) { return errorAfter<lm::ScanPoses>(change); };
    EXPECT_EQ(error([](auto& m) { m.poses[0].rms = NaN; }), "none") << "not known";
    EXPECT_THAT(error([](auto& m) { m.poses[1].scan = 0; }), HasSubstr("poses.scan"));
    EXPECT_THAT(error([](auto& m) { m.poses[1].overlap = Infinity; }), HasSubstr("poses.overlap"));
    EXPECT_THAT(error([](auto& m) { m.poses[1].scan_in_map.orientation.w = 5; }), HasSubstr("quaternion"));
    EXPECT_THAT(error([](auto& m) { m.poses[0].trust = 3; }), HasSubstr("poses.trust"));
    EXPECT_THAT(error([](auto& m) { m.cause = 3; }), HasSubstr("cause"));
}

TEST(ScanLinks, AreRigidAndAsSureAsTheySay) {
    const auto error = [](auto change) { return errorAfter<lm::ScanLinks>(change); };
    EXPECT_EQ(error([](auto&) {}), "none");
    EXPECT_EQ(error([](auto& m) { m.links[0].information.fill(0.0); }), "none") << "it says nothing";
    EXPECT_THAT(error([](auto& m) { m.links[0].id = 0; }), HasSubstr("links.id"));
    EXPECT_THAT(error([](auto& m) { m.links[0].to_scan = 0; }), HasSubstr("links"));
    EXPECT_THAT(error([](auto& m) { m.links[0].kind = 7; }), HasSubstr("links.kind"));
    EXPECT_THAT(error([](auto& m) { m.links[0].to_in_from.orientation.w = 5; }), HasSubstr("quaternion"));
    EXPECT_THAT(error([](auto& m) { m.links[0].to_in_from.position.x = NaN; }), HasSubstr("to_in_from"));
    EXPECT_THAT(error([](auto& m) { m.links[0].information[3] = NaN; }), HasSubstr("links.information"));
    EXPECT_THAT(error([](auto& m) { m.links[0].information[0] = -1.0; }), HasSubstr("links.information"));
    EXPECT_THAT(error([](auto& m) { m.links[0].information[0] = 1e200; }), HasSubstr("links.information"));
    EXPECT_THAT(error([](auto& m) { m.links[0].information[1] = 1e6; }), HasSubstr("links.information"))
        << "more between two directions than each of them has";
    EXPECT_THAT(error([](auto& m) { m.links.resize(10'001, m.links[0]); }), HasSubstr("at most 10000"));
}

TEST(ScanBodies, AreFootprintsOfAScan) {
    const auto error = [](auto change) { return errorAfter<lm::ScanBodies>(change); };
    EXPECT_EQ(error([](auto&) {}), "none");
    EXPECT_EQ(error([](auto& m) { m.scans[0].bodies.clear(); }), "none") << "none after all";
    const auto body = [&](auto change) { return error([&](auto& m) { change(m.scans[0].bodies[1]); }); };
    EXPECT_THAT(error([](auto& m) { m.scans[1].scan = 0; }), HasSubstr("scans.scan"));
    EXPECT_THAT(body([](auto& b) { b.footprint.pop_back(); }), HasSubstr("found 2"));
    EXPECT_THAT(body([](auto& b) { b.footprint.resize(65); }), HasSubstr("bodies.footprint"));
    EXPECT_THAT(body([](auto& b) { b.footprint[0].x = 10.1; }), HasSubstr("bodies.footprint"));
    EXPECT_THAT(body([](auto& b) { b.footprint[0].y = NaN; }), HasSubstr("bodies.footprint"));
    EXPECT_THAT(body([](auto& b) { b.height = NaN; }), HasSubstr("bodies.height"));
    EXPECT_THAT(body([](auto& b) { b.margin = 1.1; }), HasSubstr("bodies.margin"));
    EXPECT_THAT(body([](auto& b) { b.base_in_scan.orientation.w = 5; }), HasSubstr("quaternion"));
    EXPECT_THAT(error([](auto& m) { m.scans[0].bodies.resize(4'001, m.scans[0].bodies[0]); }),
                HasSubstr("at most 4000"));
    EXPECT_THAT(error([](auto& m) { m.scans.resize(4'001, m.scans[1]); }), HasSubstr("at most 4000"));
}

TEST(MapCrops, AreAnAreaUnderACeilingOrEverything) {
    const auto error = [](auto change) { return errorAfter<lm::MapCrop>(change); };
    EXPECT_EQ(error([](auto&) {}), "none");
    EXPECT_EQ(error([](auto& m) { m.polygon.clear(), m.ceiling = NaN; }), "none") << "everything";
    EXPECT_THAT(error([](auto& m) { m.polygon.pop_back(); }), HasSubstr("found 2"));
    EXPECT_THAT(error([](auto& m) { m.polygon.resize(1'001); }), HasSubstr("polygon"));
    EXPECT_THAT(error([](auto& m) { m.polygon[1].y = Infinity; }), HasSubstr("polygon"));
    EXPECT_THAT(error([](auto& m) { m.ceiling = Infinity; }), HasSubstr("ceiling"));
}

TEST(MapCrops, OfTwoCornersAreNotSent) {
    const MapCropSample line{Time{}, "station-1", {{0.0, 0.0}, {1.0, 0.0}}, 2.0};
    const auto bytes = encode(Sample(line), "leitstand_msgs/msg/MapCrop");
    ASSERT_FALSE(bytes.ok());
    EXPECT_THAT(bytes.error().text, HasSubstr("found 2"));
}

TEST(MapCrops, WithoutACeilingComeBackSo) {
    SampleCase open;
    open.type = "leitstand_msgs/msg/MapCrop";
    open.sample = MapCropSample{Time{}, "station-1", {}, Infinity};
    const auto back = decodeCase(open, rawEvent(open, encoded(open)));
    ASSERT_TRUE(back.ok()) << back.error().text;
    EXPECT_EQ(back->get<MapCropSample>().ceiling, Infinity);
}

TEST(RobotPlaces, AreRigidAndOfARobot) {
    const auto error = [](auto change) { return errorAfter<lm::RobotPlace>(change); };
    EXPECT_EQ(error([](auto& m) { m.overlap = NaN; }), "none") << "not known";
    EXPECT_THAT(error([](auto& m) { m.robot.clear(); }), HasSubstr("robot"));
    EXPECT_THAT(error([](auto& m) { m.cause = 5; }), HasSubstr("cause"));
    EXPECT_THAT(error([](auto& m) { m.certainty = Infinity; }), HasSubstr("certainty"));
    EXPECT_THAT(error([](auto& m) { m.odom_in_map.orientation.w = 5; }), HasSubstr("odom_in_map"));
}

TEST(Victims, HaveANumberAPlaceAndKnownStates) {
    const auto error = [](auto change) { return errorAfter<lm::Victim>(change); };
    EXPECT_EQ(error([](auto& m) { m.heat.value = m.deviation = NaN; }), "none") << "not known";
    EXPECT_THAT(error([](auto& m) { m.number = 0; }), HasSubstr("number"));
    EXPECT_THAT(error([](auto& m) { m.status = 3; }), HasSubstr("status"));
    EXPECT_THAT(error([](auto& m) { m.kind = 4; }), HasSubstr("kind"));
    EXPECT_THAT(error([](auto& m) { m.sound.state = 3; }), HasSubstr("sound"));
    EXPECT_THAT(error([](auto& m) { m.position_in_map.z = NaN; }), HasSubstr("position_in_map"));
    EXPECT_THAT(error([](auto& m) { m.evidence[1].stamp.nanosec = 2'000'000'000; }),
                HasSubstr("evidence.stamp"));
}

TEST(Candidates, HaveAnIdAPlaceAndSharesOfOne) {
    const auto error = [](auto change) { return errorAfter<lm::Candidate>(change); };
    EXPECT_EQ(error([](auto& m) { m.confidence = m.deviation = m.cues[0].value = NaN; }), "none")
        << "not known";
    EXPECT_THAT(error([](auto& m) { m.id = 0; }), HasSubstr("id"));
    EXPECT_THAT(error([](auto& m) { m.kind = 4; }), HasSubstr("kind"));
    EXPECT_THAT(error([](auto& m) { m.confidence = 1.5; }), HasSubstr("confidence"));
    EXPECT_THAT(error([](auto& m) { m.position_in_scan.x = Infinity; }), HasSubstr("position_in_scan"));
    EXPECT_THAT(error([](auto& m) { m.cues[1].confidence = -0.5; }), HasSubstr("cues.confidence"));
}

TEST(StationEvents, NameWhatTheyAreAbout) {
    EXPECT_THAT(errorAfter<lm::Grant>([](auto& m) { m.kind = 3; }), HasSubstr("kind"));
    EXPECT_THAT(errorAfter<lm::Grant>([](auto& m) { m.action = 5; }), HasSubstr("action"));
    EXPECT_THAT(errorAfter<lm::Grant>([](auto& m) { m.station.clear(); }), HasSubstr("station"));
    EXPECT_THAT(errorAfter<lm::Undo>([](auto& m) { m.event = 0; }), HasSubstr("event"));
    EXPECT_THAT(errorAfter<lm::Alarm>([](auto& m) { m.severity = 3; }), HasSubstr("severity"));
    EXPECT_THAT(errorAfter<lm::ClockOffset>([](auto& m) { m.ahead.nanosec = 1'000'000'000; }),
                HasSubstr("ahead"));
}

TEST(Commands, AreCheckedToo) {
    using wire::sensor_msgs::JointState;
    EXPECT_THAT(errorAfter<lm::StreamCommand>([](auto& m) { m.quality = 101; }), HasSubstr("quality"));
    EXPECT_THAT(errorAfter<lm::StreamCommand>([](auto& m) { m.rate = -1; }), HasSubstr("rate"));
    EXPECT_THAT(errorAfter<lm::ModeCommand>([](auto& m) { m.mode.clear(); }), HasSubstr("mode"));
    EXPECT_EQ(errorAfter<JointState>([](auto& m) { m.effort[0] = NaN; }), "none") << "not measured";
    EXPECT_THAT(errorAfter<JointState>([](auto& m) { m.velocity[0] = Infinity; }), HasSubstr("velocity"));
    EXPECT_THAT(errorAfter<JointState>([](auto& m) { m.position.pop_back(); }), HasSubstr("position"));
    EXPECT_THAT(errorAfter<lm::Sightings>([](auto& m) { m.sightings[0].confidence = 1.5; }),
                HasSubstr("confidence"));
}

}  // namespace
}  // namespace leitstand::test
