#pragma once

#include <string_view>

namespace leitstand {

/// Prints "leitstand: TEXT" on stderr, on one line. Control characters, for example in received names, are
/// escaped (printable()).
void printProblem(std::string_view text);

/// Prints "leitstand: TEXT" on stdout in the same way.
void printNotice(std::string_view text);

/// From now on, prints messages of Qt on stderr, escaped in the same way. @p picture: omit the warnings that
/// Qt gives for every window when it runs without a display.
void printQtMessages(bool picture);

}  // namespace leitstand
