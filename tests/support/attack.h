#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace leitstand::test {

/// Prints a line for the tables "what was attacked" of the documents, which
/// packaging/attack-table.py gathers from the tests' output: @p area is log, wire or pictures.
inline void tellAttack(std::string_view area, std::string_view what, std::uint64_t howOften,
                       std::string_view whatHappened) {
    fmt::print("ATTACK|{}|{}|{}|{}\n", area, what, howOften, whatHappened);
    std::fflush(stdout);
}

}  // namespace leitstand::test
