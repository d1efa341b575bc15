#pragma once

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/raw_event.h"
#include "core/io/bag/bag_reader.h"
#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/wait.h"

namespace leitstand::test {

inline ProcessOutcome leitstandctl(const std::vector<std::string>& arguments) {
    return runProcess(program("leitstandctl"), arguments);
}

/// A recording that runs beside the test.
class Recording {
public:
    Recording(const TestDomain& domain, const std::filesystem::path& mission,
              std::vector<std::string> more = {})
        : m_process(program("leitstandctl"), arguments(domain, mission, std::move(more))) {
        EXPECT_TRUE(says("recording domain")) << m_process.out();
    }
    /// With the signal @p number; its exit code, -1 when the signal ended it.
    int stop(int number = SIGINT) {
        m_process.signal(number);
        return m_process.wait();
    }
    [[nodiscard]] std::string out() const { return m_process.out(); }
    /// Waits until it has said @p text.
    [[nodiscard]] bool says(const std::string& text,
                            std::chrono::seconds atMost = std::chrono::seconds(60)) const {
        return waitUntil([&] { return m_process.out().find(text) != std::string::npos; }, atMost);
    }

private:
    static std::vector<std::string> arguments(const TestDomain& domain, const std::filesystem::path& mission,
                                              std::vector<std::string> more) {
        more.insert(more.begin(),
                    {"record", "--out", mission.string(), "--domain", std::to_string(domain.number())});
        return more;
    }
    ChildProcess m_process;
};

/// What @p mission holds on @p topic, also while it is still written.
[[nodiscard]] inline std::vector<Payload> recordedOn(const std::filesystem::path& mission,
                                                     const std::string& topic) {
    const auto bag = BagReader::open(mission);
    if (!bag) return {};
    BagQuery query;
    query.topics = {topic};
    BagCursor cursor = (*bag)->read(query);
    std::vector<Payload> payloads;
    while (const auto event = cursor.next()) payloads.push_back(event->cdr);
    return payloads;
}

}  // namespace leitstand::test
