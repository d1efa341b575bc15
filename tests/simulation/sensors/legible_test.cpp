#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/sensors/camera/camera.h"
#include "tests/simulation/sensors/room.h"
#include "tests/support/missing_tool.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::simulation::test {
namespace {

const std::filesystem::path Decoder = "/usr/bin/zbarimg";

/// What an independent decoder reads in the picture that a robot's left camera takes from @p eye towards
/// @p target (arena's frame).
std::string readFrom(World& world, const std::shared_ptr<SharedLight>& light, const Eigen::Vector3d& eye,
                     const Eigen::Vector3d& target, const std::filesystem::path& file) {
    const Eigen::Vector3d towards = (target - eye).normalized();
    const Pose looks = poseFrom(eye, 0.0, -std::asin(towards.z()), std::atan2(towards.y(), towards.x())) *
                       opticalAt(0, 0, 0);
    const int robot = addBareRobot(world, 0.1, 0.1);
    CameraSettings settings;
    settings.model = pinholeCamera();
    settings.cameraInBase = [&](Time) { return Pose(world.state(robot).baseInArena.inverse() * looks); };
    Camera camera(settings, light, Noise(3, "left"), world.now());
    std::vector<HardwareSample> samples;
    camera.run(world, robot, samples);
    const auto& bytes = samples.at(0).sample.get<PictureSample>().content.bytes;
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return leitstand::test::runProcess(Decoder, {"--quiet", "--raw", file.string()}).out;
}

/// As sent: 320 x 240 pixels, JPEG of quality 70.
TEST(Legible, TagsOfVictimsAndCodesOfSignsFromNearby) {
    if (!std::filesystem::exists(Decoder))
        LEITSTAND_MISSING_TOOL("no zbarimg here: needs Debian's zbar-tools");
    const leitstand::test::TemporaryFolder folder;
    const auto file = folder.path() / "picture.jpg";
    int tags = 0, readTags = 0, codes = 0, readCodes = 0;
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        const Arena arena = generateArena(grade, 7);
        World world(arena, 7);
        const auto light = std::make_shared<SharedLight>();
        for (const Element& element : arena.elements) {
            const bool code = element.kind == ElementKind::Sign && element.text.starts_with("qr:");
            const bool tag = element.victim && element.victim->situation != Situation::Entombed;
            if (!code && !tag) continue;
            const std::string text = code ? element.text.substr(3) : element.victim->tag;
            const double length = element.size.x();
            const Eigen::Vector3d middle =
                element.pose * (code ? Eigen::Vector3d(0, 0, element.size.z() / 2)
                                     : Eigen::Vector3d(0.16 * length, -0.2 * length, 0.06));
            bool read = false;
            for (const double along : {-0.12, 0.0, 0.12}) {
                const Eigen::Vector3d off = element.pose.linear() * Eigen::Vector3d(along, -0.45, 0.0);
                const double up = code ? 0.0 : 0.25;
                read = read || readFrom(world, light, middle + off + Eigen::Vector3d(0, 0, up), middle, file)
                                       .find(text + "\n") != std::string::npos;
            }
            (code ? codes : tags) += 1;
            (code ? readCodes : readTags) += read ? 1 : 0;
            if (!read) std::printf("%s: %s is not read\n", arena.name.c_str(), element.name.c_str());
        }
    }
    std::printf("read: %d of %d tags of victims, %d of %d codes of signs\n", readTags, tags, readCodes,
                codes);
    EXPECT_GE(tags, 8);
    EXPECT_GE(codes, 6);
    EXPECT_EQ(readTags, tags);
    EXPECT_GE(readCodes, codes * 8 / 10) << "others hang behind things";
}

}  // namespace
}  // namespace leitstand::simulation::test
