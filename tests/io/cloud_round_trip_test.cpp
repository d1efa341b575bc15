#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/scan_source.h"
#include "core/io/clouds/xyz.h"
#include "tests/io/file_checks.h"
#include "tests/io/sample_scans.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::expectSameScan;
using test::sampleScan;
using test::TemporaryFolder;

struct Format {
    const char* name;
    const char* file;
    std::function<Result<void>(const std::filesystem::path&, const Scan&)> write;
};

void PrintTo(const Format& format, std::ostream* out) {
    *out << format.name;
}

class CloudFile : public ::testing::TestWithParam<Format> {
protected:
    Scan throughTheFile(const Scan& scan) {
        const TemporaryFolder folder;
        const auto file = folder / GetParam().file;
        const auto wrote = GetParam().write(file, scan);
        EXPECT_TRUE(wrote.ok()) << errorOf(wrote);
        auto read = readScan(file);
        EXPECT_TRUE(read.ok()) << errorOf(read);
        if (!read) return {};
        EXPECT_EQ(read->warnings, std::vector<std::string>{});
        EXPECT_EQ(read->scan.name, "room");
        return std::move(read).value().scan;
    }
};

TEST_P(CloudFile, KeepsATiltingScanExactly) {
    const Scan scan = sampleScan(Sweep::Tilting, 40, 90);
    expectSameScan(throughTheFile(scan), scan);
}

TEST_P(CloudFile, KeepsAYawingScanExactly) {
    const Scan scan = sampleScan(Sweep::Yawing, 90, 40);
    expectSameScan(throughTheFile(scan), scan);
}

TEST_P(CloudFile, KeepsAnUnorganisedCloudExactly) {
    const Scan scan = test::shuffledScan(sampleScan(Sweep::Tilting, 40, 90));
    expectSameScan(throughTheFile(scan), scan);
}

TEST_P(CloudFile, KeepsLabelsWithoutIntensitiesAndTheOtherWayRound) {
    Scan labelled = sampleScan(Sweep::Tilting, 20, 60);
    Scan bright = labelled;
    labelled.intensities.clear();
    expectSameScan(throughTheFile(labelled), labelled);
    bright.labels.clear();
    expectSameScan(throughTheFile(bright), bright);
}

TEST_P(CloudFile, KeepsFloatsToTheLastBit) {
    Scan scan;
    const float tiny = std::numeric_limits<float>::denorm_min();
    scan.points = {{0.1F, -1.0F / 3.0F, 99'999.99F}, {tiny, -tiny, 0.0F}, {1e-30F, 16'777.217F, -0.0F}};
    scan.intensities = {1e30F, -0.1F, tiny};
    expectSameScan(throughTheFile(scan), scan);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, CloudFile,
    ::testing::Values(
        Format{"PcdAscii", "room.pcd", [](auto& f, auto& s) { return writePcd(f, s, PcdEncoding::Ascii); }},
        Format{"PcdBinary", "room.pcd", [](auto& f, auto& s) { return writePcd(f, s, PcdEncoding::Binary); }},
        Format{"PcdCompressed", "room.PCD",
               [](auto& f, auto& s) { return writePcd(f, s, PcdEncoding::BinaryCompressed); }},
        Format{"PlyAscii", "room.ply", [](auto& f, auto& s) { return writePly(f, s, PlyEncoding::Ascii); }},
        Format{"PlyBinary", "room.ply", [](auto& f, auto& s) { return writePly(f, s, PlyEncoding::Binary); }},
        Format{"Xyz", "room.xyz", [](auto& f, auto& s) { return writeXyz(f, s); }}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace leitstand
