#pragma once

#include <QString>
#include <QStringList>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Returns the name under which findHtml() embeds a picture. @p find: index of the find; @p picture: index of
/// its picture; both from 0.
[[nodiscard]] QString evidenceName(std::size_t find, std::size_t picture);

/// Returns the first pages, one string per section: mission, robots, finds, searched floor, changes, score,
/// where results were computed, and what is missing.
[[nodiscard]] QStringList overviewHtml(const ReportContent& content);
/// Returns the form and evidence of the find with index @p find in @p content.
[[nodiscard]] QString findHtml(const ReportContent& content, std::size_t find);
/// Returns the way to @p find in words.
[[nodiscard]] QString wayHtml(const ReportFind& find);
/// Returns the text above @p map: its storey and heights above the floor.
[[nodiscard]] QString mapCaption(const ReportContent& content, const ReportMap& map);

}  // namespace leitstand
