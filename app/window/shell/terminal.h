#pragma once

#include <string_view>

namespace leitstand {

/// Prints "leitstand: TEXT" on stderr as one line, with what others named made printable.
void tellTerminal(std::string_view text);

/// The same on stdout.
void sayOnTerminal(std::string_view text);

/// From now on what Qt has to say goes to stderr printable, too; with @p picture its remarks on a
/// display-free platform, which come with every window, are left out.
void tellQtMessages(bool picture);

}  // namespace leitstand
