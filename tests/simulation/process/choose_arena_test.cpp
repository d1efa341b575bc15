#include "robots/simulation/process/choose_arena.h"

#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_file.h"

namespace leitstand::simulation {
namespace {

TEST(ChooseArena, ABuildingIsAsTheOptionsSay) {
    const auto usual = chooseArena("building", 5);
    ASSERT_TRUE(usual);
    EXPECT_EQ(usual->name, "building 5");
    BuildingOptions options;
    options.size = "30x20";
    options.storeys = 2;
    const auto small = chooseArena("building", 5, options);
    ASSERT_TRUE(small) << small.error().text;
    EXPECT_EQ(small->to, Eigen::Vector2d(30.0, 20.0));
    // Robots of one arena's name share one world: another building has another name.
    EXPECT_NE(small->name, usual->name);
}

TEST(ChooseArena, RefusesBuildingsThatCannotBeAndOptionsThatAreOfNoUse) {
    for (const char* size : {"1x1", "1e9", "1000000000x1000000000", "60", ""}) {
        BuildingOptions options;
        options.size = size;
        options.storeys = *size == '\0' ? 50 : 1;
        const auto refused = chooseArena("building", 1, options);
        ASSERT_FALSE(refused) << size;
        EXPECT_NE(refused.error().text.find("expected"), std::string::npos) << refused.error().text;
    }
    BuildingOptions twins;
    twins.twins = true;
    EXPECT_EQ(chooseArena("yellow", 1, twins).error().text,
              "yellow: expected no --size, --storeys, --twins or --smooth: these are of building");
    EXPECT_FALSE(chooseArena("/nowhere", 1));
}

}  // namespace
}  // namespace leitstand::simulation
