#include "app/session/interrupt.h"

#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

TEST(InterruptGuard, TheFirstSignalAsksTheWorkToStop) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const InterruptGuard guard;
        EXPECT_FALSE(guard.token().stop_requested());
        std::raise(signal);
        EXPECT_TRUE(waitUntil([&] { return guard.token().stop_requested(); })) << signal;
    }
}

TEST(InterruptGuard, ASecondSignalEndsTheProgram) {
    EXPECT_EXIT(
        {
            const InterruptGuard guard;
            std::raise(SIGINT);
            std::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
}

// A station that nohup started outlives its terminal, also after a Ctrl-C while it ends.
TEST(InterruptGuard, WhatWasIgnoredStaysSo) {
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
