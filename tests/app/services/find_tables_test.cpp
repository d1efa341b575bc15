#include "app/services/handin/finds/find_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"

namespace leitstand::test {
namespace {

TEST(FindTables, TwoCodesSideBySideAreBothHandedIn) {
    const Time now(std::chrono::seconds(100));
    ReportInput input;
    input.name = "mission";
    const auto publish = [&](const Sample& sample) {
        const std::uint64_t sequence = input.state.sequence + 1;
        input.state = fold(std::move(input.state), {sequence, now, "", "/leitstand/victims", {}, "", sample});
    };
    for (const std::uint32_t number : {1U, 2U}) {
        CandidateSample code;
        code.id = number;
        code.kind = FindSample::Kind::Code;
        code.confidence = 0.95;
        code.positionInMap = {1.0 + 0.3 * number, 0.0, 0.5};
        code.cues = {{.kind = "code", .robot = "kurt3d", .text = "yellow-" + std::to_string(number)}};
        publish(code);
        const FindSample filed = filedFrom(input.state, code, "s", now);
        publish(filed);
        publish(
            *withStatus(input.state, {filed.kind, filed.number}, FindSample::Status::Confirmed, "s", now));
    }
    const FindList list = listOf(reportOf(input), FindList::Kind::Codes);
    std::vector<std::string> texts;
    for (const ListedFind& one : list.finds) texts.push_back(one.text);
    EXPECT_THAT(texts, testing::ElementsAre("yellow-1", "yellow-2"));
}

}  // namespace
}  // namespace leitstand::test
