#include <functional>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/scan_source.h"
#include "core/io/clouds/tum.h"
#include "core/io/clouds/uos.h"
#include "core/io/clouds/xyz.h"
#include "tests/io/file_checks.h"
#include "tests/io/sample_scans.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::TemporaryFolder;
using test::written;

/// A kind of file: how to write a valid one, and how to read it; reading tells the error, empty when all is
/// well.
struct Kind {
    const char* name;
    const char* file;
    std::function<void(const std::filesystem::path&)> write;
    std::function<std::string(const std::filesystem::path&)> read;
    bool countsBytes = false;  ///< so that every cut shows
};

void PrintTo(const Kind& kind, std::ostream* out) {
    *out << kind.name;
}

Scan smallScan() {
    return test::sampleScan(Sweep::Tilting, 5, 12);
}

template <class T>
std::string complaint(const Result<T>& result) {
    return result.ok() ? std::string() : result.error().text;
}

/// What holds for every scan that a reader returns, whatever the file was.
std::string readingOf(const std::filesystem::path& file) {
    const auto read = readScan(file);
    if (!read) return read.error().text;
    const Scan& scan = read->scan;
    const std::size_t points = scan.points.size();
    EXPECT_GT(points, 0U);
    if (scan.organised()) {
        EXPECT_EQ(static_cast<std::size_t>(scan.rows) * static_cast<std::size_t>(scan.columns), points);
    }
    EXPECT_TRUE(scan.intensities.empty() || scan.intensities.size() == points);
    EXPECT_TRUE(scan.labels.empty() || scan.labels.size() == points);
    for (const Eigen::Vector3f& point : scan.points) {
        EXPECT_TRUE(point.allFinite() || point.array().isNaN().all()) << point.transpose();
    }
    return {};
}

class HostileFile : public ::testing::TestWithParam<Kind> {
protected:
    HostileFile() {
        GetParam().write(m_file);
        m_content = test::readText(m_file);
    }

    /// Reads a file of @p content, which must end in a result or in an error that names the file.
    std::string tryContent(const std::string& content) {
        std::filesystem::remove(m_file);  // writing over a file may wait for the disk
        const std::string text = GetParam().read(written(m_file, content));
        if (!text.empty()) {
            EXPECT_THAT(text, ::testing::StartsWith(m_file.string()));
            EXPECT_THAT(text,
                        ::testing::AnyOf(::testing::HasSubstr("expected"), ::testing::HasSubstr("cannot")));
        }
        return text;
    }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_file = m_folder / GetParam().file;
    std::string m_content;
};

TEST_P(HostileFile, IsReadAsItIs) {
    EXPECT_EQ(tryContent(m_content), "");
}

TEST_P(HostileFile, CutShortAnywhereIsAnErrorOrAShorterFile) {
    for (std::size_t length = 0; length < m_content.size(); ++length) {
        const std::string text = tryContent(m_content.substr(0, length));
        if (GetParam().countsBytes) {
            EXPECT_NE(text, "") << length;
        }
    }
    EXPECT_NE(tryContent(""), "");
}

TEST_P(HostileFile, WithFlippedBytesNeverCrashes) {
    std::mt19937 random(42);
    for (int round = 0; round < 2'000; ++round) {
        std::string broken = m_content;
        const auto flips = 1 + random() % 4;
        for (unsigned i = 0; i < flips; ++i) broken[random() % broken.size()] = static_cast<char>(random());
        tryContent(broken);
    }
}

TEST_P(HostileFile, WithPiecesMovedNeverCrashes) {
    std::mt19937 random(43);
    for (int round = 0; round < 500; ++round) {
        std::string broken = m_content;
        const std::size_t from = random() % broken.size();
        const std::string piece = broken.substr(from, random() % 64);
        if (round % 2 == 0) broken.erase(from, piece.size());
        broken.insert(random() % (broken.size() + 1), piece);
        tryContent(broken);
    }
}

TEST_P(HostileFile, OfGarbageIsAnError) {
    std::mt19937 random(44);
    std::string garbage(50'000, '\0');
    for (char& c : garbage) c = static_cast<char>(random());
    EXPECT_NE(tryContent(garbage), "");
    EXPECT_NE(tryContent(std::string(200'000, '\0')), "");
    EXPECT_NE(tryContent(std::string(200'000, '\n')), "");
    EXPECT_NE(tryContent(std::string(200'000, '7')), "");
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, HostileFile,
    ::testing::Values(
        Kind{"Uos", "a.3d", [](auto& f) { ASSERT_TRUE(writeUosPoints(f, smallScan())); }, &readingOf},
        Kind{"Xyz", "a.xyz", [](auto& f) { ASSERT_TRUE(writeXyz(f, smallScan())); }, &readingOf},
        Kind{"PcdAscii", "a.pcd", [](auto& f) { ASSERT_TRUE(writePcd(f, smallScan(), PcdEncoding::Ascii)); },
             &readingOf},
        Kind{"PcdBinary", "a.pcd",
             [](auto& f) { ASSERT_TRUE(writePcd(f, smallScan(), PcdEncoding::Binary)); }, &readingOf, true},
        Kind{"PcdCompressed", "a.pcd",
             [](auto& f) { ASSERT_TRUE(writePcd(f, smallScan(), PcdEncoding::BinaryCompressed)); },
             &readingOf, true},
        Kind{"PlyAscii", "a.ply", [](auto& f) { ASSERT_TRUE(writePly(f, smallScan(), PlyEncoding::Ascii)); },
             &readingOf},
        Kind{"PlyBinary", "a.ply",
             [](auto& f) { ASSERT_TRUE(writePly(f, smallScan(), PlyEncoding::Binary)); }, &readingOf, true},
        Kind{"Pose", "a.pose",
             [](auto& f) {
                 ASSERT_TRUE(writeUosPose(f, poseFrom({1, 2, 3}, 0, 0.1, 1)));
             },
             [](auto& f) { return complaint(readUosPose(f)); }},
        Kind{"Frames", "a.frames",
             [](auto& f) {
                 ASSERT_TRUE(writeUosFrames(f, {{poseFrom({1, 2, 3}, 0, 0.1, 1), 1}, {}}));
             },
             [](auto& f) { return complaint(readUosFrames(f)); }},
        Kind{"Tum", "a.tum",
             [](auto& f) {
                 ASSERT_TRUE(writeTum(f, {{}, {Time{}, poseFrom({1, 2, 3}, 0, 0, 1)}}));
             },
             [](auto& f) { return complaint(readTum(f)); }}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace leitstand
