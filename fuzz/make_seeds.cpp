// Writes the seeds of fuzz/corpus: small valid files and samples. Run by hand when a format changes.
#include <cstdio>
#include <fstream>

#include <fmt/format.h>

#include "core/io/pcd.h"
#include "core/io/ply.h"
#include "core/io/tum.h"
#include "core/io/uos.h"
#include "core/io/xyz.h"
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

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_seeds fuzz/corpus\n");
        return 2;
    }
    if (!writeFiles(argv[1])) {
        std::fprintf(stderr, "make_seeds: %s: cannot be written\n", argv[1]);
        return 1;
    }
    writeMessages(argv[1]);
    return 0;
}
