#include <memory>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/app/attack/rain.h"
#include "tests/app/robots/starts.h"
#include "tests/support/attack.h"

namespace leitstand::test {
namespace {

class StartUnderAttack : public testing::Test {
protected:
    void start(StartSettings settings) {
        const auto traffic = trafficOfARobot(3'000);
        settings.meanwhile = [&](int domain) {
            return std::make_shared<Rain>(domain, traffic, settings.seed);
        };
        const double median = Starts(settings).run();
        tellAttack("wire",
                   "starts of robot, recorder and station among 1,000 packets a second of every kind (times)",
                   static_cast<std::uint64_t>(settings.runs),
                   fmt::format("all heard, after {:.1f} s (median)", median));
    }
};
using LongStartUnderAttackLatency = StartUnderAttack;
using StartUnderAttackLong = StartUnderAttack;

TEST_F(LongStartUnderAttackLatency, FiveTimes) {
    start({.runs = 5, .seed = 11});
}
TEST_F(StartUnderAttackLong, AHundredTimes) {
    start({.runs = 100, .seed = 12});
}

}  // namespace
}  // namespace leitstand::test
