#include <memory>

#include <gmock/gmock.h>
#include <QListView>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/io/bag/bag_writer.h"
#include "tests/app/window/window_page.h"
#include "tests/support/rooms.h"
#include "transport/convert/encode.h"

namespace leitstand {
namespace {

using test::WindowPage;
using test::WindowTest;
using testing::HasSubstr;
using testing::StartsWith;

Time at(int milliseconds) {
    return Time(std::chrono::seconds(1'000)) + std::chrono::milliseconds(milliseconds);
}

/// What a robot said that scanned a room from three places, as a mission's log keeps it.
class MissionTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        auto opened = BagWriter::open(m_folder / "mission");
        ASSERT_TRUE(opened) << opened.error().text;
        m_writer = std::move(opened).value();
        for (int i = 0; i < 3; ++i) saySweep(i);
        ASSERT_TRUE(m_writer->close());
        m_writer.reset();  // and its lock
    }
    [[nodiscard]] std::filesystem::path mission() const { return m_folder / "mission"; }

private:
    void publish(const std::string& topic, const Sample& sample, Time received) {
        const std::string type(typeOf(sample));
        auto payload = encode(sample, type);
        ASSERT_TRUE(payload) << payload.error().text;
        m_writer->addTopic({topic, type, qosProfilesOf({}), "", "", false, false, "cdr"});
        m_writer->write({++m_sequence, received, topic, type, std::move(payload).value()});
    }
    void saySweep(int place) {
        test::RoomSettings settings;
        settings.sweep = Sweep::Yawing;
        settings.rows = 181;
        settings.columns = 161;
        settings.seed = static_cast<unsigned>(place + 1);
        settings.sensorInRoom = poseFrom({0.3 * place - 0.4, 0.0, 0.8}, 0.0, 0.0, 0.0);
        const Scan scan = test::scanRoom(settings).scan;
        OdometrySample odometry;
        odometry.childFrame = "base_link";
        odometry.baseInOdom = settings.sensorInRoom;
        CloudSample cloud;
        cloud.header = {at(3000 * place), "base_link"};
        cloud.rows = scan.rows;
        cloud.columns = scan.columns;
        cloud.points = scan.points;
        for (const int offset : {-20, 20}) {
            odometry.header = {at(3000 * place + offset), "odom"};
            publish("/kurt3d/odom", odometry, odometry.header.stamp);
        }
        publish("/kurt3d/points", cloud, at(3000 * place + 30));
    }

    std::unique_ptr<BagWriter> m_writer;
    std::uint64_t m_sequence = 0;
};

TEST_F(MissionTest, OpensLikeAFolderOfScans) {
    WindowPage page;
    page.openAndWait({mission()});
    ASSERT_EQ(page.scans().model()->rowCount(), 3);
    EXPECT_EQ(page.cell(0, ScanListModel::Certainty), "reference");
    EXPECT_EQ(page.cell(2, ScanListModel::Certainty), "certain");
    EXPECT_THAT(page.cell(2, ScanListModel::Position), StartsWith("0.6"));
    EXPECT_THAT(page.label("mapTitle"), HasSubstr("3 scans"));
}

TEST_F(MissionTest, ADamagedOneShowsWhatIsLeftAndTellsWhatIsNot) {
    const auto file = mission() / "mission_0.db3";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) * 3 / 4);
    WindowPage page;
    page.openAndWait({mission()});
    EXPECT_GE(page.scans().model()->rowCount(), 1);
    EXPECT_LT(page.scans().model()->rowCount(), 3);
    EXPECT_THAT(page.find<QListView>("messages").model()->index(0, 0).data().toString().toStdString(),
                HasSubstr("read page by page"));
}

}  // namespace
}  // namespace leitstand
