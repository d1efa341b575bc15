#include "core/io/graph/given_links.h"

#include <optional>
#include <string_view>
#include <utility>

#include "core/io/detail/line_reader.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/pose_text.h"

namespace leitstand {
namespace {

/// Parses the link of a line; returns what was expected instead, if anything.
std::optional<std::string_view> takeLink(std::string_view line, GivenLink& into) {
    constexpr std::string_view Expectation = "i j tx ty tz qx qy qz qw, or i j no";
    const auto from = detail::toCount(detail::takeField(line));
    const auto to = detail::toCount(detail::takeField(line));
    if (!from || !to) return Expectation;
    into.from = *from;
    into.to = *to;
    std::string_view rest = line;
    if (detail::takeField(rest) == "no") {
        if (!detail::takeField(rest).empty()) return Expectation;
        return std::nullopt;
    }
    return detail::takePose(line, into.toInFrom.emplace(), Expectation);
}

}  // namespace

Result<std::vector<GivenLink>> readGivenLinks(const std::filesystem::path& file) {
    auto opened = detail::LineReader::open(file);
    if (!opened) return opened.error();
    detail::LineReader reader = std::move(opened).value();
    std::vector<GivenLink> links;
    std::string_view line;
    while (reader.next(line)) {
        std::string_view rest = line;
        const std::string_view first = detail::takeField(rest);
        if (first.empty() || first.front() == '#') continue;
        GivenLink link;
        if (const auto expectation = takeLink(line, link)) return reader.mismatch(*expectation, line);
        links.push_back(std::move(link));
    }
    if (reader.failure()) return *reader.failure();
    return links;
}

}  // namespace leitstand
