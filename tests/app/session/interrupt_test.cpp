#include "app/session/interrupt.h"

#include <csignal>
#include <cstdlib>

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
            std::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
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

}  // namespace
}  // namespace leitstand::test
