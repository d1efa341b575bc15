#include "core/io/settings/alarm_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

TEST(AlarmFile, ReadsWhatItNamesAndKeepsTheRest) {
    const auto limits = parseAlarmLimits("co2: 5000\nattitude: 50\nbattery_minutes: 15\n", "alarms.yaml");
    ASSERT_TRUE(limits) << limits.error().text;
    EXPECT_DOUBLE_EQ(limits->gas, 5'000.0);
    EXPECT_DOUBLE_EQ(limits->attitude, 0.5);
    EXPECT_DOUBLE_EQ(limits->batteryMinutes, 15.0);
    EXPECT_DOUBLE_EQ(limits->attitudeAct, AlarmLimits().attitudeAct);
    EXPECT_DOUBLE_EQ(limits->unanswered, AlarmLimits().unanswered);
}

TEST(AlarmFile, MistakesAreToldWithTheirPlace) {
    const auto limits = parseAlarmLimits("co2: much\nattitud: 50\nbattery: 300\n", "alarms.yaml");
    ASSERT_FALSE(limits);
    EXPECT_THAT(limits.error().text, testing::HasSubstr("alarms.yaml:1: co2: expected a number"));
    EXPECT_THAT(limits.error().text, testing::HasSubstr("did you mean attitude?"));
    EXPECT_THAT(limits.error().text, testing::HasSubstr("alarms.yaml:3: battery"));
    EXPECT_FALSE(parseAlarmLimits("- 1\n- 2\n", "alarms.yaml"));
}

TEST(AlarmFile, OneThatIsNotThereNamesNothing) {
    const TemporaryFolder folder;
    EXPECT_DOUBLE_EQ(readAlarmLimits(folder / "alarms.yaml").value().gas, AlarmLimits().gas);
    std::ofstream(folder / "alarms.yaml") << "# of the red arena\nco2: 900\n";
    EXPECT_DOUBLE_EQ(readAlarmLimits(folder / "alarms.yaml").value().gas, 900.0);
    EXPECT_FALSE(readAlarmLimits(folder / ".")) << "a folder is no file";
}

}  // namespace
}  // namespace leitstand::test
