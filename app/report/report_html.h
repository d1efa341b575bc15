#pragma once

#include <QString>
#include <QStringList>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Names of the pictures within the pages' HTML.
[[nodiscard]] QString evidenceName(std::size_t find, std::size_t picture);

/// The first pages, a section each: the mission, its robots, what was found, what was searched, the score,
/// what was computed where, what is missing.
[[nodiscard]] QStringList overviewHtml(const ReportContent& content);
/// A find: form and evidence.
[[nodiscard]] QString findHtml(const ReportContent& content, std::size_t find);
/// The way to it, in words.
[[nodiscard]] QString wayHtml(const ReportFind& find);
/// What stands over the map of a height.
[[nodiscard]] QString mapCaption(const ReportContent& content, const ReportMap& map);

}  // namespace leitstand
