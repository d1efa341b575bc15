#pragma once

#include <string>
#include <vector>

class QWidget;

namespace leitstand::test {

/// What in @p window cannot be used without a mouse or without eyes: fields, lists and buttons that are shown
/// and enabled and have no name for a screen reader, buttons without a tool tip, whatever Tab does not come
/// to and no key of its own triggers, rows of lists that arrows do not come to or that say nothing. In words;
/// the focus is elsewhere afterwards.
[[nodiscard]] std::vector<std::string> outOfReach(QWidget& window);

/// How many things outOfReach() looks at.
[[nodiscard]] int thingsToUse(const QWidget& window);

}  // namespace leitstand::test
