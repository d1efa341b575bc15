#include "tests/packaging/told_options.h"

#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/support/places.h"
#include "tests/support/process.h"

namespace leitstand::test {
namespace {

/// What the command of these @p words prints for --help.
std::string helpOf(const std::string& words) {
    std::istringstream in(words);
    std::string name, word;
    in >> name;
    std::vector<std::string> arguments;
    while (in >> word) arguments.push_back(word);
    arguments.push_back("--help");
    return runProcess(program(name), arguments).out;
}

void ask(const std::string& words, ToldOptions& reported) {
    // Not the reader that man pages are made with: what that overlooks must be seen here.
    static const std::regex option("\n  (-[^ :{]+)");
    const std::string help = helpOf(words);
    for (std::sregex_iterator one(help.begin(), help.end(), option), end; one != end; ++one) {
        std::istringstream names((*one)[1].str());
        for (std::string name; std::getline(names, name, ',');) reported[words].insert(name);
    }
    for (const std::string& below : commandsBelow(words)) ask(words + ' ' + below, reported);
}

}  // namespace

std::vector<std::string> programs() {
    std::vector<std::string> found;
    for (const char* name : {"leitstand", "leitstandctl", "leitstand-robot", "leitstand-guard"}) {
        if (std::filesystem::exists(program(name))) found.emplace_back(name);
    }
    return found;
}

ToldOptions askedForHelp(const std::string& name) {
    ToldOptions reported;
    ask(name, reported);
    return reported;
}

std::set<std::string> commandsBelow(const std::string& words) {
    static const std::regex name("\n  ([a-z][a-z0-9-]*) +[^ ]");
    const std::string help = helpOf(words);
    const auto begin = help.find("\nSubcommands:\n");
    std::set<std::string> found;
    if (begin == std::string::npos) return found;
    const std::string list = help.substr(begin + 13, help.find("\n\n", begin) - begin - 13);
    for (std::sregex_iterator one(list.begin(), list.end(), name), end; one != end; ++one) {
        found.insert((*one)[1].str());
    }
    return found;
}

}  // namespace leitstand::test
