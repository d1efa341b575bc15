#include "app/services/interrupt.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

/// Tests that run in the background of a script, or by nohup, begin with ignored signals.
struct InterruptGuardTest : testing::Test {
    InterruptGuardTest() {
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    }
};

TEST_F(InterruptGuardTest, TheFirstSignalAsksTheWorkToStop) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const InterruptGuard guard;
        EXPECT_FALSE(guard.token().stop_requested());
        std::raise(signal);
        EXPECT_TRUE(waitUntil([&] { return guard.token().stop_requested(); })) << signal;
    }
}

TEST_F(InterruptGuardTest, ASecondSignalEndsTheProgram) {
    EXPECT_EXIT(
        {
            const InterruptGuard guard;
            std::raise(SIGINT);
            usleep(600'000);
            std::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
}

// `timeout` tells the process and then its group, a moment later: that is one wish, and the log has to be
// closed.
TEST_F(InterruptGuardTest, OneWishMayBeToldTwice) {
    for (const int signal : {SIGINT, SIGTERM}) {
        EXPECT_EXIT(
            {
                {
                    const InterruptGuard guard;
                    std::raise(signal);
                    std::raise(signal);
                    if (!waitUntil([&] { return guard.token().stop_requested(); })) std::_Exit(2);
                    std::raise(signal);
                }
                std::_Exit(0);
            },
            testing::ExitedWithCode(0), "")
            << signal;
    }
}

// The shell tells it, and then the system.
TEST_F(InterruptGuardTest, ATerminalThatClosesMaySaySoTwice) {
    const InterruptGuard guard;
    std::raise(SIGHUP);
    std::raise(SIGHUP);
    EXPECT_TRUE(waitUntil([&] { return guard.token().stop_requested(); }));
}

// As Qt does when the display goes.
TEST_F(InterruptGuardTest, ALibraryMayExitMeanwhile) {
    EXPECT_EXIT(
        {
            const InterruptGuard guard;
            std::exit(3);
        },
        testing::ExitedWithCode(3), "");
}

// A station that nohup started outlives its terminal, also after a Ctrl-C while it ends.
TEST_F(InterruptGuardTest, WhatWasIgnoredStaysSo) {
    EXPECT_EXIT(
        {
            std::signal(SIGHUP, SIG_IGN);
            {
                const InterruptGuard guard;
                std::raise(SIGHUP);
                if (guard.token().stop_requested()) std::_Exit(1);
                std::raise(SIGTERM);
                std::raise(SIGHUP);
                if (!waitUntil([&] { return guard.token().stop_requested(); })) std::_Exit(2);
            }
            std::raise(SIGHUP);
            std::_Exit(0);
        },
        testing::ExitedWithCode(0), "");
}

// A library that hangs keeps the work from its end; what was recorded is closed all the same.
TEST_F(InterruptGuardTest, WhatHangsEndsWithinFiveSecondsAllTheSame) {
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EXIT(
        {
            const InterruptGuard guard(InterruptGuard::End::Surely);
            const WhenLate close([] { std::fputs("closed", stderr); });
            std::raise(SIGTERM);
            for (;;) pause();
        },
        testing::ExitedWithCode(1), "closed");
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(5));
}

// Also where what is to be closed hangs, too, and where the end itself does.
TEST_F(InterruptGuardTest, WhatHangsWhileItIsClosedEndsToo) {
    EXPECT_EXIT(
        {
            const InterruptGuard guard(InterruptGuard::End::Surely);
            const WhenLate close([] {
                for (;;) pause();
            });
            std::raise(SIGTERM);
            for (;;) pause();
        },
        testing::ExitedWithCode(1), "");
    EXPECT_EXIT(
        {
            {
                const InterruptGuard guard(InterruptGuard::End::Surely);
                std::raise(SIGTERM);
                while (!guard.token().stop_requested()) usleep(1000);
            }
            for (;;) pause();
        },
        testing::KilledBySignal(SIGALRM), "");
}

TEST_F(InterruptGuardTest, WhatEndsInTimeIsLeftAlone) {
    EXPECT_EXIT(
        {
            {
                const InterruptGuard guard(InterruptGuard::End::Surely);
                const WhenLate close([] { std::_Exit(7); });
                std::raise(SIGTERM);
                while (!guard.token().stop_requested()) usleep(1000);
            }
            std::exit(0);
        },
        testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace leitstand::test
