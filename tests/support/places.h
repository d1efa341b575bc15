#pragma once

#include <string>

namespace leitstand::test {

// Not by definitions on the compiler's command line: objects are then the same in every checkout, and a
// compiler cache has them.

/// The checkout that the tests were built in, without a slash at its end.
[[nodiscard]] const std::string& sourceFolder();
/// A program that was built beside this one: "leitstand-robot".
[[nodiscard]] std::string program(const std::string& name);

}  // namespace leitstand::test
