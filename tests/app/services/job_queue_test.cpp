#include "app/services/job_queue.h"

#include <atomic>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using testing::ElementsAre;

TEST(JobQueue, DoesJobsInOrder) {
    JobQueue queue;
    std::vector<int> done;
    std::stop_source end;
    for (int i = 0; i < 3; ++i) {
        queue.submit([&done, i](const std::stop_token&) { done.push_back(i); });
    }
    queue.submit([&end](const std::stop_token&) { end.request_stop(); });
    queue.work(end.get_token());
    EXPECT_THAT(done, ElementsAre(0, 1, 2));
}

TEST(JobQueue, WhatSomebodyWaitsForComesFirst) {
    JobQueue queue;
    std::vector<int> done;
    std::stop_source end;
    queue.submit([&done](const std::stop_token&) { done.push_back(1); });
    queue.submitFirst([&done](const std::stop_token&) { done.push_back(0); });
    queue.submit([&end](const std::stop_token&) { end.request_stop(); });
    queue.work(end.get_token());
    EXPECT_THAT(done, ElementsAre(0, 1));
}

TEST(JobQueue, ACancelReachesTheJobAtWorkAndThoseWaiting) {
    JobQueue queue;
    std::stop_source end;
    std::vector<bool> cancelled;
    queue.submit([&](const std::stop_token& stop) {
        queue.cancel();
        cancelled.push_back(stop.stop_requested());
    });
    queue.submit([&](const std::stop_token& stop) { cancelled.push_back(stop.stop_requested()); });
    queue.submit([&](const std::stop_token& stop) { cancelled.push_back(stop.stop_requested()); }, false);
    queue.submit([&end](const std::stop_token&) { end.request_stop(); });
    queue.work(end.get_token());
    EXPECT_THAT(cancelled, ElementsAre(true, true, false));
}

TEST(JobQueue, AWaitingWorkerEndsWhenAskedTo) {
    JobQueue queue;
    std::atomic<bool> worked = false;
    std::jthread worker([&queue](const std::stop_token& stop) { queue.work(stop); });
    queue.submit([&worked](const std::stop_token&) {
        worked = true;
        worked.notify_all();
    });
    worked.wait(false);
    worker.request_stop();
    worker.join();
    EXPECT_FALSE(worker.joinable());
}

}  // namespace
}  // namespace leitstand
