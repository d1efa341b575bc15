#pragma once

#include <string>
#include <vector>

namespace leitstand::test {

/// A sentence of a comment: text up to a full stop, a colon before a list, or the end of a list's item.
struct Sentence {
    int line = 0;  ///< on which its comment begins
    std::string text;

    [[nodiscard]] int words() const;
};

/// The sentences of all comments in the C++ text @p source.
[[nodiscard]] std::vector<Sentence> sentences(const std::string& source);

/// A place in a document that a comment cites: docs/NAME.md, "Heading".
struct Citation {
    std::string document, heading;
};

/// The citations in the comments of @p source, also those that go on in the next line. Of `docs/a.md, "One"
/// and "Two"` both.
[[nodiscard]] std::vector<Citation> citations(const std::string& source);

}  // namespace leitstand::test
