#include "robots/control/fuzzy/fuzzy_system.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/control/fuzzy/fuzzy_file.h"
#include "tests/robots/control/test_ground.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
constexpr double Infinity = std::numeric_limits<double>::infinity();

TEST(FuzzySet, TrianglesTrapezoidsAndShoulders) {
    const FuzzySet trapezoid{1, 2, 4, 6};
    for (const auto& [value, member] : std::vector<std::pair<double, double>>{
             {0.5, 0}, {1, 0}, {1.5, 0.5}, {2, 1}, {3, 1}, {4, 1}, {5, 0.5}, {6, 0}, {7, 0}})
        EXPECT_DOUBLE_EQ(trapezoid.membership(value), member) << value;
    EXPECT_DOUBLE_EQ((FuzzySet{0, 1, 1, 2}).membership(1.0), 1.0);
    EXPECT_DOUBLE_EQ((FuzzySet{0, 1, 1, 2}).membership(1.25), 0.75);
    const FuzzySet low{-Infinity, -Infinity, 1, 2};
    EXPECT_DOUBLE_EQ(low.membership(-1e9), 1.0);
    EXPECT_DOUBLE_EQ(low.membership(1.5), 0.5);
    EXPECT_DOUBLE_EQ(low.membership(2.5), 0.0);
    EXPECT_DOUBLE_EQ((FuzzySet{1, 2, Infinity, Infinity}).membership(1e9), 1.0);
    const FuzzySet steep{1, 1, 2, 2};
    EXPECT_DOUBLE_EQ(steep.membership(1.0), 1.0);
    EXPECT_DOUBLE_EQ(steep.membership(0.999), 0.0);
    EXPECT_DOUBLE_EQ(steep.membership(std::nan("")), 0.0);
}

constexpr const char* Small = R"(and: minimum
inputs:
  a: {range: [0, 10], terms: {small: [0, 0, 2, 4], big: [2, 4, inf, inf]}}
  b: {range: [0, 10], terms: {small: [0, 0, 2, 4], big: [2, 4, inf, inf]}}
outputs:
  y: {range: [-1, 1], terms: {low: [-1, -0.5, 0], high: [0, 0.5, 1]}}
rules:
  - if a is big and b is small then y is high
  - if a is small then y is low
  - if a is big and b is not small then y is low with 0.5
)";

TEST(FuzzySystem, MinimumProductNegationAndWeight) {
    auto system = parseFuzzySystem(Small, "small.yaml");
    ASSERT_TRUE(system) << system.error().text;
    FuzzySystem fuzzy = *system;
    FuzzyResult result = fuzzy.infer({{"a", 3.5}, {"b", 3.0}});
    EXPECT_THAT(result.strengths, testing::ElementsAre(0.5, 0.25, 0.25));
    EXPECT_EQ(result.strongest(), 0);
    fuzzy.conjunction = FuzzySystem::And::Product;
    result = fuzzy.infer({{"a", 3.5}, {"b", 3.0}});
    EXPECT_THAT(result.strengths, testing::ElementsAre(0.375, 0.25, 0.1875));
}

TEST(FuzzySystem, TheCentreOfGravityIsThatOfTheUnion) {
    const auto system = parseFuzzySystem(Small, "small.yaml");
    ASSERT_TRUE(system);
    EXPECT_NEAR(system->infer({{"a", 10.0}, {"b", 0.0}}).outputs.at("y"), 0.5, 1e-6);
    EXPECT_NEAR(system->infer({{"a", 0.0}, {"b", 0.0}}).outputs.at("y"), -0.5, 1e-6);
    // Triangles of half-width 0.5 cut at h have the area 0.5 * (2 - h) * h * ... : both cut at 0.5 balance.
    EXPECT_NEAR(system->infer({{"a", 3.0}, {"b", 0.0}}).outputs.at("y"), 0.0, 1e-6);
    // a = 3.5: high cut at 0.75 (area 0.46875), low at 0.25 (area 0.21875), centres at +-0.5.
    const double expected = 0.5 * (0.46875 - 0.21875) / (0.46875 + 0.21875);
    EXPECT_NEAR(system->infer({{"a", 3.5}, {"b", 0.0}}).outputs.at("y"), expected, 2e-3);
}

TEST(FuzzySystem, WhereNoRuleAppliesOutputsAreZero) {
    const auto system = parseFuzzySystem(Small, "small.yaml");
    ASSERT_TRUE(system);
    for (const FuzzyValues& values : {FuzzyValues{}, FuzzyValues{{"a", std::nan("")}}}) {
        const FuzzyResult result = system->infer(values);
        EXPECT_EQ(result.strongest(), -1);
        EXPECT_DOUBLE_EQ(result.outputs.at("y"), 0.0);
    }
}

TEST(FuzzyFile, TellsLineAndKeyOfEverythingThatIsWrong) {
    const auto fails = [](const std::string& text) {
        const auto system = parseFuzzySystem(text, "f.yaml");
        return system ? std::string("read") : system.error().text;
    };
    std::string bad = Small;
    bad.replace(bad.find("a is small"), 10, "c is small");
    EXPECT_THAT(fails(bad), HasSubstr("f.yaml:9: rules[1]: expected an input, found \"c\""));
    bad = Small;
    bad.replace(bad.find("y is low"), 8, "y is lax");
    EXPECT_THAT(fails(bad), HasSubstr("f.yaml:9: rules[1]: expected y to be high or low, found \"lax\""));
    bad = Small;
    bad.replace(bad.find("[0, 0, 2, 4]"), 12, "[0, 3, 2, 4]");
    EXPECT_THAT(fails(bad),
                HasSubstr("f.yaml:3: inputs.a.terms.small: expected three or four rising numbers"));
    bad = Small;
    bad.replace(bad.find("with 0.5"), 8, "with 5.0");
    EXPECT_THAT(fails(bad), HasSubstr("f.yaml:10: rules[2]: expected a weight from 0 to 1"));
    bad = Small;
    bad.replace(bad.find("and: minimum"), 12, "and: maximum");
    EXPECT_THAT(fails(bad), HasSubstr("f.yaml:1: and: expected minimum or product"));
    bad = Small;
    bad.replace(bad.find("range: [-1, 1]"), 14, "range: [1, -1]");
    EXPECT_THAT(fails(bad), HasSubstr("f.yaml:6: outputs.y.range: expected the lower number first"));
    bad = Small;
    bad.replace(bad.find("if a is small then"), 18, "when a is small then");
    EXPECT_THAT(fails(bad), HasSubstr("rules[1]: expected \"if ... then ...\""));
    EXPECT_THAT(fails("inputs: {}\n"), HasSubstr("f.yaml: expected inputs, outputs and rules"));
    EXPECT_THAT(fails("rulez: []\n"), HasSubstr("did you mean rules?"));
    EXPECT_THAT(fails("{"), HasSubstr("f.yaml:"));
    EXPECT_THAT(readFuzzySystem("/nowhere/f.yaml").error().text, HasSubstr("/nowhere/f.yaml"));
    EXPECT_FALSE(parseFuzzyRule("if a is small then y is not low"));
    EXPECT_FALSE(parseFuzzyRule("if a small then y is low"));
    EXPECT_FALSE(parseFuzzyRule(""));
}

/// A value for which @p set is true altogether, within @p low and @p high.
double coreOf(const FuzzySet& set, double low, double high) {
    return 0.5 * (std::clamp(set.b, low, high) + std::clamp(set.c, low, high));
}

/// Nothing near, the goal ahead.
FuzzyValues freeGround() {
    return {{"front", 3.0}, {"front_left", 3.0}, {"front_right", 3.0}, {"left", 3.0}, {"right", 3.0},
            {"rear", 3.0},  {"goal", 0.0},       {"goal_free", 3.0},   {"open", 0.0}};
}

TEST(ShippedRules, EachAppliesWhereItShouldAndTellsTheRightWay) {
    const FuzzyDrive drive = shippedDrive();
    const FuzzySystem& system = drive.system();
    ASSERT_GE(system.rules.size(), 15U);
    for (std::size_t r = 0; r < system.rules.size(); ++r) {
        const FuzzyRule& rule = system.rules[r];
        FuzzyValues values = freeGround();
        for (const FuzzyClause& clause : rule.conditions) {
            const FuzzyVariable& variable = system.inputs.at(clause.variable);
            if (!clause.negated)
                values[clause.variable] = coreOf(variable.terms.at(clause.term), variable.low, variable.high);
        }
        EXPECT_NEAR(system.strength(rule, values), rule.weight, 1e-9) << rule.text;
        EXPECT_EQ(system.strength(rule, {}), 0.0);
        FuzzySystem alone = system;
        alone.rules = {rule};
        const FuzzyResult result = alone.infer(values);
        for (const FuzzyClause& clause : rule.conclusions) {
            const FuzzySet& set = system.outputs.at(clause.variable).terms.at(clause.term);
            const double value = result.outputs.at(clause.variable);
            EXPECT_GE(value, set.a - 1e-9) << rule.text;
            EXPECT_LE(value, set.d + 1e-9) << rule.text;
        }
        const double together = system.infer(values).outputs.at("turn");
        const double turn = result.outputs.at("turn");
        EXPECT_TRUE(std::abs(turn) < 0.05 || together * turn > 0.0) << rule.text;
    }
}

TEST(ShippedRules, AreAsGoodToTheLeftAsToTheRight) {
    const FuzzyDrive drive = shippedDrive();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> distance(0.0, 1.5), direction(-180.0, 180.0);
    for (int i = 0; i < 300; ++i) {
        FuzzyValues values = freeGround();
        for (auto& [name, value] : values)
            value = name == "goal" || name == "open" ? direction(random) : distance(random);
        FuzzyValues mirrored = values;
        std::swap(mirrored["left"], mirrored["right"]);
        std::swap(mirrored["front_left"], mirrored["front_right"]);
        mirrored["goal"] = -values["goal"];
        mirrored["open"] = -values["open"];
        const FuzzyResult result = drive.system().infer(values), other = drive.system().infer(mirrored);
        EXPECT_GE(result.strongest(), 0) << "a rule for everything";
        EXPECT_NEAR(result.outputs.at("speed"), other.outputs.at("speed"), 1e-6);
        EXPECT_NEAR(result.outputs.at("turn"), -other.outputs.at("turn"), 1e-6);
    }
}

TEST(ShippedRules, DriveAsOneWouldExpect) {
    const FuzzyDrive drive = shippedDrive();
    const auto infer = [&](std::initializer_list<std::pair<const char*, double>> changes) {
        FuzzyValues values = freeGround();
        for (const auto& [name, value] : changes) values[name] = value;
        return drive.system().infer(values).outputs;
    };
    EXPECT_GT(infer({}).at("speed"), 0.85);
    EXPECT_NEAR(infer({}).at("turn"), 0.0, 0.02);
    EXPECT_LT(infer({{"front", 0.4}}).at("speed"), 0.5) << "slower before a wall";
    EXPECT_LT(std::abs(infer({{"front", 0.05}, {"open", 60.0}}).at("speed")), 0.05);
    EXPECT_GT(infer({{"front", 0.05}, {"open", 60.0}}).at("turn"), 0.3);
    EXPECT_LT(infer({{"front", 0.05}}).at("speed"), -0.1) << "backs off";
    EXPECT_GT(infer({{"goal", 150.0}}).at("turn"), 0.7);
    EXPECT_LT(infer({{"goal", -150.0}}).at("turn"), -0.7);
    EXPECT_LT(std::abs(infer({{"goal", 150.0}}).at("speed")), 0.05) << "turns on the spot";
    EXPECT_LT(infer({{"front_left", 0.05}}).at("turn"), 0.0) << "away from a corner";
}

TEST(FuzzyDrive, SteersIntoFreeSpaceWithoutAGoal) {
    TestGround ground(maze({"+-+-+-+", "|     |", "+ +-+ +", "|     |", "+-+-+-+"}, 1.6), 3);
    ground.place(0.8, 0.8, 0.2);
    const FuzzyDrive drive = shippedDrive();
    double way = 0.0;
    Eigen::Vector3d before = ground.baseInGround().translation();
    while (ground.seconds() < 90.0) {
        ground.step(ground.seconds() < 2.6 ? DriveVelocity{}
                                           : drive.step(ground.view(), std::nullopt).velocity);
        way += (ground.baseInGround().translation() - before).norm();
        before = ground.baseInGround().translation();
    }
    EXPECT_EQ(ground.touches(), 0);
    EXPECT_GT(way, 6.0);
    std::printf("%.1f m in 90 s\n", way);
}

// It went to and fro in it, whichever way was free for longer just then.
TEST(FuzzyDrive, LeavesAnAlleyInWhichItCannotTurnAsItCame) {
    const FuzzyDrive drive = shippedDrive();
    const BodyBox& body = drive.settings().safety.body;
    const auto alley = [&](double ahead, double ageBehind) {
        VirtualScanView view;
        view.sectors.resize(360);
        for (int i = 0; i < 360; ++i) {
            const bool behind = std::abs(view.directionOf(i)) > degrees(120);
            view.sectors[static_cast<std::size_t>(i)].age = behind ? ageBehind : 0.5;
        }
        for (double x = -2.0; x < ahead; x += 0.02) {
            view.obstacles.push_back({{x, body.left + 0.06}, 0.5, 1.0});
            view.obstacles.push_back({{x, -body.right - 0.06}, 0.5, 1.0});
        }
        for (double y = -0.3; y < 0.3; y += 0.02) view.obstacles.push_back({{ahead, y}, 0.5, 1.0});
        return view;
    };
    for (const double ahead : {0.4, 0.6, 1.0, 1.6}) {
        for (const double goal : {degrees(150), degrees(-150), degrees(100)})
            EXPECT_LT(drive.step(alley(ahead, 0.5), goal).velocity.forward, -0.03) << ahead;
    }
    EXPECT_GE(drive.step(alley(1.6, 20.0), degrees(150)).velocity.forward, 0.0) << "it does not see behind";
}

TEST(FuzzyDrive, RefusesRulesThatItDoesNotUnderstand) {
    const auto system = parseFuzzySystem(Small, "small.yaml");
    ASSERT_TRUE(system);
    const auto drive = FuzzyDrive::create(*system, {});
    ASSERT_FALSE(drive.ok());
    EXPECT_THAT(drive.error().text, HasSubstr("inputs.a: expected one of front, front_left"));
}

}  // namespace
}  // namespace leitstand::test
