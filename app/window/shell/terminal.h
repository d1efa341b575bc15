#pragma once

#include <string_view>

namespace leitstand {

/// Prints "leitstand: TEXT" on stderr as one line. Control characters, for example in received names, are
/// escaped (printable()).
void printProblem(std::string_view text);

/// Prints "leitstand: TEXT" on stdout in the same way.
void printNotice(std::string_view text);

/// Prints messages of Qt on stderr from now on, escaped in the same way. @p picture: drops the warnings that
/// Qt gives with every window when it runs without a display.
void printQtMessages(bool picture);

}  // namespace leitstand
