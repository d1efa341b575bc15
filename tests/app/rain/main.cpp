// rain DOMAIN [SEED]
//     hostile datagrams of every kind, a thousand a second, on the loopback ports of DOMAIN: made of what a
//     simulated robot says in another domain, which is listened to first. Says "rains on DOMAIN" when they
//     begin to fall, and at the end how many fell.
// Runs until SIGTERM.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>

#include "tests/app/attack/rain.h"

namespace {

using namespace leitstand::test;

constexpr std::size_t Packets = 3'000;  ///< that are listened to

volatile std::sig_atomic_t ended = 0;

}  // namespace

int main(int count, char** words) try {
    if (count < 2) return 2;
    const int domain = std::stoi(words[1]);
    const unsigned seed = count > 2 ? static_cast<unsigned>(std::stoul(words[2])) : 1;
    std::signal(SIGTERM, [](int) { ended = 1; });
    const auto traffic = trafficOfARobot(Packets);
    const Rain rain(domain, traffic, seed);
    std::printf("rains on %d\n", domain);
    std::fflush(stdout);
    while (ended == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::printf("%llu fell\n", static_cast<unsigned long long>(rain.fallen()));
    return 0;
} catch (const std::exception& problem) {
    std::fprintf(stderr, "rain: %s\n", problem.what());
    return 1;
}
