#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/robot_description.h"
#include "tests/architecture/sources.h"

namespace leitstand::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// Loops over, and references to, a part of a snapshot that nobody holds. What says state(), mission(),
/// scans() or robots() hands out a shared pointer, which in C++20 is gone before a loop over a part of it
/// begins; another thread may then free it.
std::vector<std::string> unheldSnapshots(const std::string& text) {
    static const std::regex loop(R"(for \([^;{}]* : [^;{}]*\b(state|mission|scans|robots)\(\)->)"),
        whole(R"(for \([^;{}]* : \*[^;{}]*(\.|->)(state|mission|scans|robots)\(\)\))"),
        reference(R"(& \w+ = [^;{}]*\b(state|mission|scans)\(\)->)");
    std::vector<std::string> found;
    for (const std::regex* const rule : {&loop, &whole, &reference}) {
        for (std::sregex_iterator one(text.begin(), text.end(), *rule), end; one != end; ++one)
            found.push_back(one->str());
    }
    return found;
}

TEST(Snapshots, WhoLooksAtAPartHoldsTheWhole) {
    const auto files = sources({"core", "transport", "robots", "widgets", "app", "tests"});
    EXPECT_GT(files.size(), 100U);
    for (const std::string& file : files) {
        if (file == "tests/architecture/snapshots_test.cpp") continue;
        EXPECT_THAT(unheldSnapshots(content(file)), IsEmpty()) << file;
    }
}

TEST(Snapshots, UnheldOnesAreSeen) {
    EXPECT_THAT(unheldSnapshots("for (const auto& one : *mission->state()->finds) {"), SizeIs(1));
    EXPECT_THAT(unheldSnapshots("for (const RobotInMap& one : *mapping->robots()) {"), SizeIs(1));
    EXPECT_THAT(unheldSnapshots("if (const auto& clock = m_mission.state()->clock; clock)"), SizeIs(1));
    EXPECT_THAT(unheldSnapshots("const auto state = mission->state();\nfor (auto& one : *state->finds) {"),
                IsEmpty());
    EXPECT_THAT(unheldSnapshots("for (const RobotDescription& one : station.robots()) {"), IsEmpty());
    EXPECT_THAT(unheldSnapshots("const std::size_t count = mapping.scans()->scans.size();"), IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
