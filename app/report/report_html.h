#pragma once

#include <QString>

#include "app/session/report/report_content.h"

namespace leitstand {

/// Names of the pictures within the pages' HTML.
[[nodiscard]] QString evidenceName(std::size_t find, std::size_t picture);

/// The first page: the mission, its robots, what was found, what was computed where, what is missing.
[[nodiscard]] QString overviewHtml(const ReportContent& content);
/// A find: form, evidence and way.
[[nodiscard]] QString findHtml(const ReportContent& content, std::size_t find);
/// What stands over the map of a height.
[[nodiscard]] QString mapCaption(const ReportContent& content, std::size_t band);

}  // namespace leitstand
