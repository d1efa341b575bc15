#pragma once

#include <string>

#include "app/services/handin/report_content.h"
#include "core/base/result.h"

namespace leitstand {

/// Lays out @p content as a PDF (A4) and returns its bytes. It contains the mission, maps with numbered
/// finds, and a block for each find with its evidence and the way to it. Error without a QGuiApplication (the
/// offscreen platform is sufficient). Any thread. Equal contents give equal pages; the creation time is in
/// the file's properties.
[[nodiscard]] Result<std::string> pdfOf(const ReportContent& content);

}  // namespace leitstand
