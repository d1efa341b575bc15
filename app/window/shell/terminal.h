#pragma once

#include <string_view>

namespace leitstand {

/// Prints "leitstand: TEXT" on stderr as one line. Names that others chose are made printable.
void printProblem(std::string_view text);

/// Prints "leitstand: TEXT" on stdout in the same way.
void printNotice(std::string_view text);

/// Sends messages of Qt to stderr from now on, made printable. With @p picture, drops its remarks on a
/// display-free platform, which come with every window.
void printQtMessages(bool picture);

}  // namespace leitstand
