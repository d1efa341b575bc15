#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace leitstand::test {

/// Options of each command of a program, by its words: "leitstandctl keys show" to "-h", "--help", "--json".
using ToldOptions = std::map<std::string, std::set<std::string>>;

/// The programs that are installed: "leitstandctl".
[[nodiscard]] std::vector<std::string> programs();

/// What @p name and its subcommands print for --help.
[[nodiscard]] ToldOptions askedForHelp(const std::string& name);
/// Subcommands that @p words, a command's, list in their help.
[[nodiscard]] std::set<std::string> commandsBelow(const std::string& words);

}  // namespace leitstand::test
