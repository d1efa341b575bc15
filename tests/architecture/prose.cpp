#include "tests/architecture/prose.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <utility>

namespace leitstand::test {

namespace {

/// What one line has of a comment; where it goes on from the line before, both are of one comment.
struct CommentLine {
    std::string text;
    bool goesOn = false;
};

CommentLine commentOf(const std::string& line, bool afterTrailing) {
    const std::size_t first = line.find_first_not_of(' ');
    static const std::regex trailing(R"(\s///< ?(.*)$|\s// ?(.*)$)");
    std::smatch found;
    if (first != std::string::npos && line.compare(first, 2, "//") == 0) {
        std::string text = line.substr(first + 2);
        const bool ofTrailing = text.starts_with("/<");
        text.erase(0, std::min(text.find_first_not_of("/<"), text.size()));
        return {text, ofTrailing == afterTrailing};
    }
    if (line.find('"') == std::string::npos && std::regex_search(line, found, trailing))
        return {found[1].matched ? found[1].str() : found[2].str(), false};
    return {};
}

/// The comments of @p source, each with its first line; items of lists are comments of their own.
std::vector<Sentence> comments(const std::string& source) {
    std::vector<Sentence> all;
    std::istringstream in(source);
    std::string line;
    bool open = false, trailing = false;
    for (int number = 1; std::getline(in, line); ++number) {
        const CommentLine one = commentOf(line, trailing);
        const std::size_t text = one.text.find_first_not_of(' ');
        if (text == std::string::npos) {
            open = trailing = false;
            continue;
        }
        const bool item = one.text.compare(text, 2, "- ") == 0 || one.text[text] == '|' ||
                          (std::isdigit(static_cast<unsigned char>(one.text[text])) != 0 &&
                           one.text.compare(text + 1, 2, ". ") == 0);
        if (open && one.goesOn && !item)
            all.back().text += " " + one.text.substr(text);
        else
            all.push_back({number, one.text.substr(text)});
        if (!one.goesOn) trailing = line.find("///<") != std::string::npos;
        open = true;
    }
    return all;
}

}  // namespace

int Sentence::words() const {
    std::istringstream in(text);
    int count = 0;
    for (std::string word; in >> word;)
        count += std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
    return count;
}

std::vector<Sentence> sentences(const std::string& source) {
    std::vector<Sentence> all;
    for (const Sentence& comment : comments(source)) {
        std::string now;
        std::istringstream in(comment.text);
        for (std::string word; in >> word;) {
            now += (now.empty() ? "" : " ") + word;
            if (std::string(".!?").find(word.back()) == std::string::npos) continue;
            all.push_back({comment.line, std::exchange(now, {})});
        }
        if (!now.empty()) all.push_back({comment.line, now});
    }
    return all;
}

std::vector<Citation> citations(const std::string& source) {
    static const std::regex cited(R"re((docs/[a-z-]+\.md), ("[^"]+"(?: and "[^"]+")*))re");
    static const std::regex heading(R"re("([^"]+)")re");
    std::vector<Citation> all;
    for (const Sentence& comment : comments(source)) {
        for (std::sregex_iterator one(comment.text.begin(), comment.text.end(), cited), end; one != end;
             ++one) {
            const std::string headings = (*one)[2];
            for (std::sregex_iterator of(headings.begin(), headings.end(), heading); of != end; ++of)
                all.push_back({(*one)[1], (*of)[1]});
        }
    }
    return all;
}

}  // namespace leitstand::test
