#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/graph/g2o_file.h"
#include "tests/app/recording.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// "EDGE_SE3:QUAT" of a shift by @p x, that is known alike in all directions.
std::string edge(int from, int to, const std::string& x) {
    return "EDGE_SE3:QUAT " + std::to_string(from) + " " + std::to_string(to) + " " + x +
           " 0 0 0 0 0 1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n";
}

/// Three nodes in a row, the last one of which lies 0.2 m too far.
std::string row() {
    return "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\n"
           "VERTEX_SE3:QUAT 2 2.2 0 0 0 0 0 1\n" +
           edge(0, 1, "1") + edge(1, 2, "1") + edge(0, 2, "2");
}

TEST(GraphCommand, SolvesAGraphTellsItsCostAndWritesIt) {
    const TemporaryFolder folder;
    writeText(folder / "row.g2o", row());
    const std::string out = (folder / "solved.g2o").string();
    const auto run = leitstandctl({"graph", (folder / "row.g2o").string(), "--out", out, "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json reported = json::parse(run.out);
    EXPECT_EQ(reported["nodes"], 3);
    EXPECT_EQ(reported["links"], 3);
    EXPECT_NEAR(reported["cost_before"].get<double>(), 0.04, 1e-12) << "half of 0.2 squared, twice";
    EXPECT_LT(reported["cost"].get<double>(), 1e-9);
    EXPECT_TRUE(reported["converged"]);
    const auto solved = readG2o(out);
    ASSERT_TRUE(solved) << solved.error().text;
    EXPECT_NEAR(solved->nodes.back().pose.translation().x(), 2.0, 1e-6);
    const auto table = leitstandctl({"graph", (folder / "row.g2o").string()});
    EXPECT_THAT(table.out, HasSubstr("3 nodes, 3 links"));
}

TEST(GraphCommand, TheRobustSolverDismissesWhatContradictsTheRest) {
    const TemporaryFolder folder;
    writeText(folder / "wrong.g2o", row() + edge(0, 2, "30"));
    const std::string out = (folder / "solved.g2o").string();
    const auto run = leitstandctl(
        {"graph", (folder / "wrong.g2o").string(), "--solver", "robust", "--out", out, "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["dismissed"], 1);
    const auto solved = readG2o(out);
    ASSERT_TRUE(solved) << solved.error().text;
    EXPECT_EQ(solved->links.size(), 3U);
    EXPECT_NEAR(solved->nodes.back().pose.translation().x(), 2.0, 1e-3);
}

TEST(GraphCommand, NamesTheLineThatItCannotRead) {
    const TemporaryFolder folder;
    writeText(folder / "cut.g2o", "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nEDGE_SE3:QUAT 0 7 1\n");
    const auto run = leitstandctl({"graph", (folder / "cut.g2o").string()});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, HasSubstr("cut.g2o:2: "));
}

}  // namespace
}  // namespace leitstand::test
