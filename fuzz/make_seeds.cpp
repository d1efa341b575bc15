// Writes the seeds of fuzz/corpus: small valid files and samples. Run by hand when a format changes.
#include <cstdio>
#include <fstream>

#include <fmt/format.h>
#include <sqlite3.h>
#include <opencv2/imgcodecs.hpp>

#include "core/event/stream_role.h"
#include "core/io/bag/bag_writer.h"
#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/tum.h"
#include "core/io/clouds/uos.h"
#include "core/io/clouds/xyz.h"
#include "core/io/pad/pad_file.h"
#include "core/io/settings/comparison_file.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/fold.h"
#include "fuzz/small_bag.h"
#include "tests/core/perception/video/filmed.h"
#include "tests/support/samples.h"
#include "transport/convert/encode.h"
#include "transport/convert/message_catalog.h"

namespace {

using namespace leitstand;
namespace fs = std::filesystem;

Scan smallScan() {
    Scan scan;
    scan.rows = 2;
    scan.columns = 3;
    for (int i = 0; i < 6; ++i) {
        scan.points.emplace_back(0.5F * static_cast<float>(i), 1.0F, -0.25F);
        scan.intensities.push_back(static_cast<float>(i));
        scan.labels.push_back(static_cast<Label>(i % 4));
    }
    scan.points[3].setConstant(std::numeric_limits<float>::quiet_NaN());
    return scan;
}

void write(const fs::path& file, const std::string& bytes) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
}

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The file at @p from with the byte that chooses its kind before it.
void writeChosen(const fs::path& file, char choice, const fs::path& from) {
    write(file, choice + content(from));
    fs::remove(from);
}

bool writeFiles(const fs::path& corpus) {
    const Scan scan = smallScan();
    for (const char* folder : {"pcd", "ply", "uos", "xyz", "poses"}) fs::create_directories(corpus / folder);
    const fs::path pose = corpus / "pose", frames = corpus / "frames", tum = corpus / "tum";
    const Pose some = poseFrom({1, 2, 3}, 0, 0.1, 1);
    const bool done = writePcd(corpus / "pcd/ascii", scan, PcdEncoding::Ascii).ok() &&
                      writePcd(corpus / "pcd/binary", scan, PcdEncoding::Binary).ok() &&
                      writePcd(corpus / "pcd/compressed", scan, PcdEncoding::BinaryCompressed).ok() &&
                      writePly(corpus / "ply/ascii", scan, PlyEncoding::Ascii).ok() &&
                      writePly(corpus / "ply/binary", scan, PlyEncoding::Binary).ok() &&
                      writeUosPoints(corpus / "uos/scan", scan).ok() &&
                      writeXyz(corpus / "xyz/scan", scan).ok() && writeUosPose(pose, some).ok() &&
                      writeUosFrames(frames, {{some, 1}, {}}).ok() &&
                      writeTum(tum, {{Time{}, some}, {Time(std::chrono::seconds(1)), some}}).ok();
    if (!done) return false;
    writeChosen(corpus / "poses/pose", '\0', pose);
    writeChosen(corpus / "poses/frames", '\1', frames);
    writeChosen(corpus / "poses/tum", '\2', tum);
    write(corpus / "poses/given", "\3# by hand\n0 7 1 2 3 0 0 0.6 0.8\n3 9 no\n");
    return true;
}

void writeMessages(const fs::path& corpus) {
    const auto types = messageTypes();
    for (const test::SampleCase& one : test::sampleCases()) {
        const auto payload = encode(one.sample, one.type);
        const MessageType* type = findMessageType(one.type);
        if (!payload || type == nullptr) continue;
        std::string bytes;
        bytes += static_cast<char>(type - types.data());
        bytes += static_cast<char>(one.role.value_or(StreamRole::Points));
        bytes += '\0';
        bytes.append(reinterpret_cast<const char*>((*payload)->data()), (*payload)->size());
        std::string name = one.type.substr(one.type.rfind('/') + 1);
        if (one.role) name += "-" + toString(*one.role);
        if (bytes.size() <= 4'096) write(corpus / "messages" / name, bytes);
    }
}

/// A bag of three events, of the smallest pages that SQLite has.
bool writeBag(const fs::path& corpus) {
    const fs::path mission = corpus / "mission";
    auto opened = BagWriter::open(mission);
    if (!opened) return false;
    const auto writer = std::move(opened).value();
    writer->addTopic(
        {"/kurt3d/gas", "std_msgs/msg/Float32", qosProfilesOf({}), "float32 data", "", false, false, "cdr"});
    for (std::uint64_t i = 1; i <= 3; ++i) {
        const auto cdr = std::make_shared<const std::vector<std::byte>>(8, std::byte{1});
        writer->write({i, Time(std::chrono::seconds(i)), "/kurt3d/gas", "std_msgs/msg/Float32", cdr});
    }
    bool done = writer->close().ok();
    sqlite3* database = nullptr;
    done = done && sqlite3_open(writer->file().c_str(), &database) == SQLITE_OK &&
           sqlite3_exec(database, "PRAGMA journal_mode=DELETE; PRAGMA page_size=512; VACUUM", nullptr,
                        nullptr, nullptr) == SQLITE_OK;
    sqlite3_close(database);
    if (done) write(corpus / "bag/small", content(writer->file()));
    if (done) write(corpus / "bag_metadata/small", content(mission / "metadata.yaml"));
    fs::remove_all(mission);
    return done;
}

/// Bindings of a known pad, and a comparison of three scans.
void writeSettings(const fs::path& corpus) {
    write(corpus / "pad/standard", padText(defaultBindings(PadLayout::Standard), "a pad"));
    MapComparison whole;
    for (int i = 1; i <= 3; ++i) {
        ComparedScan one;
        one.id = static_cast<std::uint64_t>(i);
        one.recorded = one.again = poseFrom({1.0 * i, -0.5, 0.1}, 0.01, 0.02, 3.0);
        if (i > 1) one.fitRecorded = one.fitAgain = ScanFit{0.0123, 0.81};
        whole.scans.push_back(one);
    }
    whole.recorded.truth = TrajectoryError{.poses = 3, .position = 0.031, .rotation = 0.01};
    whole.again.finds = FindsError{.finds = 2, .mean = 0.2, .worst = 0.3, .missed = 4, .wrong = 1};
    sumUp(whole);
    write(corpus / "comparison/three", writeComparison(whole));
}

/// The log of a bag after two transactions, as a killed writer leaves it.
bool writeLog(const fs::path& corpus) {
    const fs::path folder = corpus / "wal-made";
    fs::create_directories(folder);
    sqlite3* bag = fuzz::openSmallBag(folder / "a.db3");
    const bool done = bag != nullptr && fuzz::addMessages(bag, 2);
    if (done) write(corpus / "wal/two", content(folder / "a.db3-wal"));
    sqlite3_close(bag);
    fs::remove_all(folder);
    return done;
}

/// States of a mission in which everything was said once, and nothing.
void writeCheckpoints(const fs::path& corpus) {
    MissionState state;
    const auto text = [&] {
        const auto bytes = serialised(state);
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    write(corpus / "checkpoint/empty", text());
    for (const test::SampleCase& one : test::sampleCases()) {
        Event event;
        event.sequence = state.sequence + 1;
        event.received = Time(std::chrono::seconds(event.sequence));
        event.robot = one.role ? "kurt3d" : "";
        event.topic = one.role ? "/kurt3d/" + toString(*one.role) : "/leitstand/" + one.type;
        event.role = one.role;
        event.sample = one.sample;
        state = fold(std::move(state), event);
    }
    write(corpus / "checkpoint/all", text());
}

/// A picture of 4 x 3 in every kind that fuzz_picture chooses.
void writePictures(const fs::path& corpus) {
    const cv::Mat colour(3, 4, CV_8UC3, cv::Scalar(200, 100, 50)), warm(3, 4, CV_16UC1, cv::Scalar(30'000));
    std::vector<unsigned char> jpeg, png, thermal;
    cv::imencode(".jpg", colour, jpeg);
    cv::imencode(".png", colour, png);
    cv::imencode(".png", warm, thermal);
    const auto text = [](const std::vector<unsigned char>& file) {
        return std::string(file.begin(), file.end());
    };
    const std::string unused(5, '\0');
    write(corpus / "picture/jpeg", '\0' + unused + text(jpeg));
    write(corpus / "picture/png", '\1' + unused + text(png));
    write(corpus / "picture/thermal", '\1' + unused + text(thermal));
    for (char choice = 2; choice < 10; ++choice) {
        const std::string head = {choice, 4, 3, 4, 0, 0};  // rows of 16 bytes
        write(corpus / "picture" / fmt::format("raw{}", int(choice)), head + std::string(48, '\x40'));
    }
}

/// Two pictures of a video for each codec that fuzz_video chooses.
void writeVideos(const fs::path& corpus) {
    for (const VideoCodec codec : {VideoCodec::H264, VideoCodec::H265}) {
        std::string text(1, static_cast<char>(codec));
        for (const PictureSample& sample : test::filmed(2, 10, codec, 32, 32)) {
            const auto bytes = sample.content.bytes;
            text += static_cast<char>(bytes.size() % 256);
            text += static_cast<char>(bytes.size() / 256);
            text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        }
        write(corpus / "video" / (codec == VideoCodec::H264 ? "h264" : "h265"), text);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_seeds fuzz/corpus\n");
        return 2;
    }
    if (!writeFiles(argv[1]) || !writeBag(argv[1]) || !writeLog(argv[1])) {
        std::fprintf(stderr, "make_seeds: %s: cannot be written\n", argv[1]);
        return 1;
    }
    writeSettings(argv[1]);
    writeMessages(argv[1]);
    writePictures(argv[1]);
    writeVideos(argv[1]);
    writeCheckpoints(argv[1]);
    return 0;
}
