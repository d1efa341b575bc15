#pragma once

#include <string>

#include "app/services/handin/report_content.h"
#include "core/base/result.h"

namespace leitstand {

/// Lays @p content out as a PDF (A4) and gives its bytes: mission, maps with numbered finds, a block for each
/// find with its evidence and the way to it. A QGuiApplication must exist (the offscreen platform will do);
/// any thread. Equal contents make equal pages; the creation time is in the file's properties.
[[nodiscard]] Result<std::string> pdfOf(const ReportContent& content);

}  // namespace leitstand
