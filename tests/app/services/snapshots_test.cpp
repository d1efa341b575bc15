#include "app/services/station/cameras/snapshots.h"

#include <fstream>
#include <iterator>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// A grey picture of 16 x 12 numbers, shown as something else altogether.
ShownPicturePtr picture() {
    auto bytes = std::make_shared<std::vector<std::byte>>();
    for (int i = 0; i < 2 * 16 * 12; ++i) bytes->push_back(static_cast<std::byte>(7 * i % 251));
    auto shown = std::make_shared<ShownPicture>();
    shown->robot = "kurt3d";
    shown->sensor = "ir";
    shown->received = Time(std::chrono::milliseconds(1'700'000'000'250));
    shown->sample.encoding = "16UC1";
    shown->sample.width = 16;
    shown->sample.height = 12;
    shown->sample.step = 32;
    shown->sample.content = {bytes, *bytes};
    shown->content = Picture{1, 1, Picture::Pixel::Grey8, {std::byte{9}}};
    return shown;
}

class SnapshotsTest : public testing::Test {
protected:
    std::unique_ptr<Snapshots> keeper(const fs::path& mission) {
        return std::make_unique<Snapshots>(
            mission, Snapshots::Listener{[this](const std::string& robot, const fs::path& file) {
                                             EXPECT_EQ(robot, "kurt3d");
                                             const std::scoped_lock lock(m_mutex);
                                             m_files.push_back(file);
                                         },
                                         [this](const std::string& why) {
                                             const std::scoped_lock lock(m_mutex);
                                             m_problems.push_back(why);
                                         }});
    }
    TemporaryFolder m_folder;
    std::mutex m_mutex;
    std::vector<fs::path> m_files;
    std::vector<std::string> m_problems;
};

std::vector<std::byte> bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<std::byte> bytes;
    for (std::istreambuf_iterator<char> at(in), end; at != end; ++at)
        bytes.push_back(static_cast<std::byte>(*at));
    return bytes;
}

TEST_F(SnapshotsTest, KeepThePictureAsItCameWithWhatIsKnown) {
    auto snapshots = keeper(m_folder / "mission");
    SnapshotRequest request;
    request.picture = picture();
    request.camera = "Infrared";
    request.baseInOdom = poseFrom({1.5, -2.0, 0.0}, 0, 0, 0);
    request.turned = PanTiltAngles{degrees(30), degrees(-5)};
    snapshots->take(request);
    snapshots->take(request);
    snapshots->finish();
    ASSERT_EQ(m_files.size(), 2U) << (m_problems.empty() ? "" : m_problems.front());
    EXPECT_EQ(m_files[0], fs::path("snapshots/kurt3d_ir_2023-11-14_22-13-20.250.png"));
    EXPECT_NE(m_files[0], m_files[1]) << "nothing is overwritten";
    const std::vector<std::byte> bytes = bytesOf(m_folder / "mission" / m_files[0].string());
    PictureSample file;
    file.compressed = true;
    file.content = {std::make_shared<const std::vector<std::byte>>(bytes), bytes};
    const auto back = decodePicture(file);
    ASSERT_TRUE(back.ok()) << back.error().text;
    EXPECT_EQ(back->pixel, Picture::Pixel::Grey16);
    EXPECT_TRUE(std::equal(back->bytes.begin(), back->bytes.end(),
                           request.picture->sample.content.bytes.begin(),
                           request.picture->sample.content.bytes.end()));
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_THAT(text, testing::HasSubstr("kurt3d: Infrared"));
    EXPECT_THAT(text, testing::HasSubstr("1.5000 -2.0000 0.0000"));
    EXPECT_THAT(text, testing::HasSubstr("30.0 -5.0"));
}

TEST_F(SnapshotsTest, TellWhyTheDiskTookNone) {
    std::ofstream(m_folder / "mission") << "a file where a folder should be";
    auto snapshots = keeper(m_folder / "mission");
    snapshots->take({picture(), "Infrared", {}, {}});
    snapshots->finish();
    EXPECT_TRUE(m_files.empty());
    ASSERT_EQ(m_problems.size(), 1U);
    EXPECT_THAT(m_problems[0], testing::HasSubstr("snapshots"));
}

TEST_F(SnapshotsTest, ThatWaitAreWrittenAtTheEnd) {
    auto snapshots = keeper(m_folder / "mission");
    for (int i = 0; i < 5; ++i) snapshots->take({picture(), "Infrared", {}, {}});
    snapshots.reset();
    EXPECT_EQ(m_files.size(), 5U);
    int whole = 0;
    for (const auto& entry : fs::directory_iterator(m_folder / "mission" / "snapshots"))
        whole += entry.path().extension() == ".png" ? 1 : 0;
    EXPECT_EQ(whole, 5);
}

}  // namespace
}  // namespace leitstand::test
