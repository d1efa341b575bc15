#include <cstring>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/xyz.h"
#include "tests/io/file_checks.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::TemporaryFolder;
using test::written;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

std::string bytesOf(std::initializer_list<float> numbers) {
    std::string bytes;
    for (const float number : numbers) {
        char raw[4];
        std::memcpy(raw, &number, 4);
        bytes.append(raw, 4);
    }
    return bytes;
}

std::string bigEndian(std::string bytes) {
    for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
        std::swap(bytes[i], bytes[i + 3]);
        std::swap(bytes[i + 1], bytes[i + 2]);
    }
    return bytes;
}

std::string pcdHeader(const std::string& size, const std::string& data,
                      const std::string& fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n") {
    return "VERSION 0.7\n" + fields + size + "DATA " + data + "\n";
}

std::string plyHeader(const std::string& format, const std::string& elements) {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::string Vertex = "property float x\nproperty float y\nproperty float z\n";

class PcdError : public ::testing::Test {
protected:
    std::string errorFor(const std::string& content) { return errorOf(readPcd(written(m_file, content))); }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_file = m_folder / "a.pcd";
};

TEST_F(PcdError, NamesTheLineOfWhatIsWrongInTheHeader) {
    EXPECT_EQ(errorFor("VERSION 0.7\nFEELDS x y z\n"),
              m_file.string() +
                  ":2: expected an entry of a PCD header (FIELDS, SIZE, TYPE, WIDTH, ..., DATA), "
                  "found \"FEELDS x y z\"");
    EXPECT_THAT(errorFor("WIDTH -3\n"),
                HasSubstr(":1: expected a whole number from 0 on, found \"WIDTH -3\""));
    EXPECT_THAT(errorFor("SIZE 4 four 4\n"), HasSubstr(":1: expected whole numbers from 1 on"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 1\n", "zipped")), HasSubstr("expected DATA ascii, binary"));
}

TEST_F(PcdError, SaysWhatTheHeaderLacks) {
    EXPECT_THAT(errorFor("VERSION 0.7\nFIELDS x y z\n"), EndsWith("expected a PCD header that ends in DATA"));
    EXPECT_THAT(errorFor(pcdHeader("", "ascii")), HasSubstr("WIDTH"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 0\n", "ascii")),
                HasSubstr("expected in the header points, found none"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2\nHEIGHT 3\nPOINTS 5\n", "ascii")),
                HasSubstr("POINTS to be WIDTH x HEIGHT = 6, found 5"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 1\n", "ascii", "FIELDS x y\nSIZE 4 4\nTYPE F F\n")),
                HasSubstr("fields x, y and z"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 1\n", "ascii", "FIELDS x y z\nSIZE 4 4\nTYPE F F F\n")),
                HasSubstr("as many SIZE, TYPE and COUNT as FIELDS"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 1\n", "ascii", "FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\n")),
                HasSubstr("a known type of field \"z\""));
}

TEST_F(PcdError, RefusesAbsurdSizesWithoutTakingMemory) {
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2000000000\nHEIGHT 1\n", "binary") + "abc"),
                HasSubstr("expected 2000000000 points, which take at least 24000000000 bytes, found 3"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2000000000\n", "ascii") + "1 2 3\n"), HasSubstr("found 6"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 18446744073709551615\n", "binary")), HasSubstr("below 2^31"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2000000000\nHEIGHT 2000000000\n", "binary")),
                HasSubstr("2^31 points"));
    EXPECT_THAT(errorFor(pcdHeader("COUNT 1 1 4000000000\nWIDTH 1\n", "binary")), HasSubstr("256 KiB"));
    const std::string sizes("\x10\x00\x00\x00\x00\xe4\x0b\x54", 8);  // 16 bytes that become 1,410,065,408
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 117505451\n", "binary_compressed") + sizes + std::string(16, 'x')),
                HasSubstr("decompressed bytes, found 1410065408"));
    const std::string honest("\x10\x00\x00\x00\x00\xe4\x0b\x54", 8);
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 352516352\n", "binary_compressed",
                                   "FIELDS x y z l\nSIZE 1 1 1 1\nTYPE U U U U\n") +
                         honest + std::string(16, 'x')),
                HasSubstr("expected 16 compressed bytes, found 16"));
}

TEST_F(PcdError, NamesLineOrByteOfABrokenPoint) {
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2\n", "ascii") + "1 2 3\n4 five 6\n"),
                HasSubstr(":8: expected 3 numbers, found \"4 five 6\""));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2\n", "ascii") + "1 2 3\n1 2 3 4\n"),
                HasSubstr(":8: expected 3 numbers"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2\n", "ascii") + "1 2 3\n1 2 1e30\n"),
                HasSubstr(":8: expected finite coordinates within 100 km"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 2\n", "ascii") + "1.0 2.0 3.0\n\n"),
                HasSubstr("expected 2 points, found 1"));
    const std::string header = pcdHeader("WIDTH 2\n", "binary");
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_THAT(errorFor(header + bytesOf({1, 2, 3, 4, infinity, 6})),
                HasSubstr(": byte " + std::to_string(header.size() + 12) + ": expected finite coordinates"));
    EXPECT_THAT(errorFor(header + bytesOf({1, 2, 3, 4, 5})), HasSubstr("take at least 24 bytes, found 20"));
    EXPECT_THAT(errorFor(pcdHeader("WIDTH 1\n", "binary_compressed") +
                         std::string("\x04\0\0\0\x0c\0\0\0\xff\xff\xff\xff", 12)),
                HasSubstr("expected points compressed by LZF"));
}

TEST_F(PcdError, IsNoneForForeignFieldsOfAnyTypeAndBlanks) {
    const auto read = readPcd(written(
        m_file,
        "# comment\r\nVERSION .7\r\nCOLUMNS rgb z y x histogram\r\nSIZE 4 4 4 8 4\r\nTYPE U F F F I\r\n"
        "COUNT 1 1 1 1 2\r\nWIDTH 2\r\nHEIGHT 1\r\nVIEWPOINT 0 0 0 1 0 0 0\r\nDATA ascii\r\n"
        "7 3 2 1 0 0\r\n\r\n7 nan 2 1 0 0\r\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_EQ(read->scan.points[0], Eigen::Vector3f(1, 2, 3));
    EXPECT_TRUE(read->scan.points[1].array().isNaN().all());
    EXPECT_TRUE(read->scan.intensities.empty());
}

TEST_F(PcdError, ForeignLabelsAreLeftOutWithAWarning) {
    const std::string fields = "FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\n";
    const auto read =
        readPcd(written(m_file, pcdHeader("WIDTH 2\n", "ascii", fields) + "1 2 3 1\n4 5 6 17\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_TRUE(read->scan.labels.empty());
    EXPECT_THAT(read->warnings, ElementsAre(HasSubstr("a.pcd: its labels are left out")));
}

class PlyError : public ::testing::Test {
protected:
    std::string errorFor(const std::string& content) { return errorOf(readPly(written(m_file, content))); }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_file = m_folder / "a.ply";
};

TEST_F(PlyError, NamesTheLineOrWhatTheHeaderLacks) {
    EXPECT_THAT(errorFor("plie\n"), HasSubstr("a.ply: expected a PLY file that begins with \"ply\""));
    EXPECT_THAT(errorFor("ply\nformat ascii 2.0\n"), HasSubstr(":2: expected format ascii"));
    EXPECT_THAT(errorFor("ply\nelement vertex many\n"), HasSubstr(":2: expected element NAME COUNT"));
    EXPECT_THAT(errorFor("ply\nproperty float x\n"),
                HasSubstr(":2: expected an element before its properties"));
    EXPECT_THAT(errorFor("ply\nelement vertex 1\nproperty real x\n"),
                HasSubstr(":3: expected property TYPE NAME"));
    EXPECT_THAT(errorFor("ply\nvertices\n"), HasSubstr(":2: expected an entry of a PLY header"));
    EXPECT_THAT(errorFor("ply\nformat ascii 1.0\n"),
                HasSubstr("expected a PLY header that ends in end_header"));
    EXPECT_THAT(errorFor("ply\nelement vertex 1\n" + Vertex + "end_header\n1 2 3\n"),
                HasSubstr("in the header a format"));
    EXPECT_THAT(errorFor(plyHeader("ascii", "element face 1\n")), HasSubstr("vertices, found none"));
    EXPECT_THAT(errorFor(plyHeader("ascii", "element vertex 1\nproperty float x\n")),
                HasSubstr("with x, y and z"));
    EXPECT_THAT(errorFor(plyHeader("ascii", "element vertex 1\n" + Vertex + "property list uchar int l\n")),
                HasSubstr("vertices without lists"));
    EXPECT_THAT(errorFor(plyHeader("binary_little_endian",
                                   "element face 1\nproperty list uchar int l\nelement vertex 1\n" + Vertex)),
                HasSubstr("no lists before the vertices"));
    EXPECT_THAT(errorFor(plyHeader("binary_little_endian", "element vertex 2000000000\n" + Vertex) + "abc"),
                HasSubstr("take at least 24000000000 bytes, found 3"));
    EXPECT_THAT(errorFor(plyHeader("binary_little_endian", "element vertex 99999999999999\n" + Vertex)),
                HasSubstr("fewer than 2^31 vertices"));
    EXPECT_THAT(errorFor(plyHeader("ascii", "element vertex 2\n" + Vertex) + "1 2 3\n4 5 six\n"),
                HasSubstr(":9: expected 3 numbers, found \"4 5 six\""));
    EXPECT_THAT(errorFor(plyHeader("ascii", "element vertex 2\n" + Vertex) + "1.5 2.5 3.5\n"),
                HasSubstr("expected 2 points, found 1"));
}

TEST_F(PlyError, IsNoneForBigEndianAndElementsAround) {
    const std::string elements =
        "comment made elsewhere\nelement camera 2\nproperty float a\nelement vertex 2\n" + Vertex +
        "property float reflectance\nelement face 1\nproperty list uchar int vertex_index\n";
    const std::string numbers = bytesOf({7, 7, 1, 2, 3, 0.5F, 4, 5, 6, 0.25F});
    for (const bool big : {false, true}) {
        const auto read =
            readPly(written(m_file, big ? plyHeader("binary_big_endian", elements) + bigEndian(numbers)
                                        : plyHeader("binary_little_endian", elements) + numbers));
        ASSERT_TRUE(read.ok()) << errorOf(read);
        EXPECT_THAT(read->scan.points, ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)));
        EXPECT_THAT(read->scan.intensities, ElementsAre(0.5F, 0.25F));
    }
}

TEST(XyzError, NamesLineAndExpectation) {
    const TemporaryFolder folder;
    const auto errorFor = [&](const std::string& content) {
        return errorOf(readXyz(written(folder / "a.xyz", content)));
    };
    EXPECT_THAT(errorFor("1 2 3\n1,2\n"), HasSubstr("a.xyz:2: expected three numbers, found \"1,2\""));
    EXPECT_THAT(errorFor("1;2;x\n"), HasSubstr(":1: expected three numbers"));
    EXPECT_THAT(errorFor("1 2 3\n-inf 2 3\n"), HasSubstr(":2: expected finite coordinates within 100 km"));
    EXPECT_THAT(errorFor("691000 5336000 500\n"), HasSubstr(":1: expected finite coordinates within 100 km"));
    EXPECT_THAT(errorFor("1 2 3 inf\n"), HasSubstr(":1: expected a finite intensity"));
    EXPECT_THAT(errorFor(""), HasSubstr("expected points, found none"));
}

TEST(Xyz, ReadsWhatOtherToolsWrite) {
    const TemporaryFolder folder;
    const auto read = readXyz(written(
        folder / "a.xyz", "//X Y Z Label R\r\n\r\n1, 2;3\t1 x\r\n# done?\n0 0 0 3 y\nnan nan nan 0 z"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    ASSERT_EQ(read->scan.points.size(), 3U);
    EXPECT_EQ(read->scan.points[0], Eigen::Vector3f(1, 2, 3));
    EXPECT_EQ(read->scan.points[1], Eigen::Vector3f(0, 0, 0)) << "the map's origin is a place like any other";
    EXPECT_TRUE(read->scan.points[2].array().isNaN().all());
    EXPECT_THAT(read->scan.labels, ElementsAre(Label::Floor, Label::Ceiling, Label::Unlabelled));
    EXPECT_TRUE(read->scan.intensities.empty());
}

}  // namespace
}  // namespace leitstand
