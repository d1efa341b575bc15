#include "core/io/graph/g2o_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/file_checks.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::TemporaryFolder;
using test::written;
using ::testing::HasSubstr;

const std::string Unit = " 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1";
const std::string Two = "VERTEX_SE3:QUAT 4 1 2 3 0 0 0 1\nVERTEX_SE3:QUAT 2 0 0 0 0 0 0 2\n";

TEST(G2o, ReadsNodesByRisingIdLinksAndWhatIsFixed) {
    const TemporaryFolder folder;
    const auto read =
        readG2o(written(folder / "a.g2o", "# a graph\r\n" + Two + "\nEDGE_SE3:QUAT 2 4 1 2 3 0 0 0 1" +
                                              " 1 2 0 0 0 0 9 0 0 0 0 1 0 0 0 1 0 0 1 0 1\nFIX 4\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    ASSERT_EQ(read->nodes.size(), 2U);
    EXPECT_EQ(read->nodes[0].id, 2U);
    EXPECT_FALSE(read->nodes[0].fixed);
    EXPECT_TRUE(read->nodes[1].fixed);
    EXPECT_TRUE(read->nodes[0].pose.isApprox(Pose::Identity())) << "quaternions are normalised";
    ASSERT_EQ(read->links.size(), 1U);
    EXPECT_EQ(read->links[0].information(1, 0), 2.0);
    EXPECT_EQ(read->links[0].information(0, 1), 2.0);
    EXPECT_EQ(read->links[0].information(1, 1), 9.0);
    EXPECT_EQ(read->links[0].kind, LinkKind::Loop);
}

TEST(G2o, RoundTripsAGraph) {
    const TemporaryFolder folder;
    PoseGraph graph;
    graph.nodes = {{1, poseFrom({1, 2, 3}, 0.1, 0.2, 3.0), true},
                   {1'000'000'007, poseFrom({-1, 1e-7, 9e4}, -3, 1.5, 0), false}};
    Link link;
    link.from = 1;
    link.to = 1'000'000'007;
    link.pose = poseFrom({0.1, 1.0 / 3.0, -2}, 1, 0, 2);
    link.information(2, 5) = link.information(5, 2) = 0.25;
    graph.links = {link, link};
    graph.links[1].active = false;
    ASSERT_TRUE(writeG2o(folder / "a.g2o", graph).ok());
    const auto back = readG2o(folder / "a.g2o");
    ASSERT_TRUE(back.ok()) << errorOf(back);
    ASSERT_EQ(back->nodes.size(), 2U);
    ASSERT_EQ(back->links.size(), 1U) << "a link that does not count is left out";
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(back->nodes[i].id, graph.nodes[i].id);
        EXPECT_EQ(back->nodes[i].fixed, graph.nodes[i].fixed);
        EXPECT_TRUE(back->nodes[i].pose.isApprox(graph.nodes[i].pose, 1e-12));
    }
    EXPECT_EQ(back->links[0].information, link.information);
    EXPECT_TRUE(back->links[0].pose.isApprox(link.pose, 1e-12));
}

struct Broken {
    const char* what;
    std::string text, expected;
};
class G2oErrors : public testing::TestWithParam<Broken> {};

TEST_P(G2oErrors, NameFilePlaceAndExpectation) {
    const TemporaryFolder folder;
    const auto read = readG2o(written(folder / "bad.g2o", GetParam().text));
    ASSERT_FALSE(read.ok());
    EXPECT_THAT(errorOf(read), HasSubstr("bad.g2o"));
    EXPECT_THAT(errorOf(read), HasSubstr(GetParam().expected));
}

INSTANTIATE_TEST_SUITE_P(
    Each, G2oErrors,
    testing::Values(
        Broken{"empty", "", "expected vertices, found none"},
        Broken{"planar", "VERTEX_SE2 0 1 2 3\n", ":1: expected VERTEX_SE3:QUAT, EDGE_SE3:QUAT or FIX"},
        Broken{"cutOff", Two + "EDGE_SE3:QUAT 2 4 1 2 3 0 0", ":3: expected EDGE_SE3:QUAT from to"},
        Broken{"notANumber", "VERTEX_SE3:QUAT 0 nan 0 0 0 0 0 1\n", ":1: expected VERTEX_SE3:QUAT id"},
        Broken{"huge", "VERTEX_SE3:QUAT 0 1e300 0 0 0 0 0 1\n", ":1: expected VERTEX_SE3:QUAT id"},
        Broken{"noTurn", "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 0\n", ":1: expected VERTEX_SE3:QUAT id"},
        Broken{"more", "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1 5\n", ":1: expected VERTEX_SE3:QUAT id"},
        Broken{"negativeId", "VERTEX_SE3:QUAT -1 0 0 0 0 0 0 1\n", ":1: expected VERTEX_SE3:QUAT id"},
        Broken{"twice", Two + "VERTEX_SE3:QUAT 2 0 0 0 0 0 0 1\n",
               ":3: expected an id that no vertex before it has"},
        Broken{"nobody", Two + "EDGE_SE3:QUAT 2 5 1 2 3 0 0 0 1" + Unit,
               "expected a vertex 5, which the edge in line 3"},
        Broken{"negative",
               Two + "EDGE_SE3:QUAT 2 4 1 2 3 0 0 0 1 -1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n",
               ":3: expected an information that is positive semidefinite"},
        Broken{"fixesNobody", Two + "FIX 9\n", "expected a vertex 9"},
        Broken{"fixesWords", Two + "FIX me\n", ":3: expected FIX"}),
    [](const auto& test) { return test.param.what; });

TEST(G2o, AMissingFileIsNamed) {
    EXPECT_THAT(errorOf(readG2o("/nowhere/a.g2o")), HasSubstr("/nowhere/a.g2o"));
}

}  // namespace
}  // namespace leitstand
