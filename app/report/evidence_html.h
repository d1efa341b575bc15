#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// A picture of the evidence, and how it is printed.
struct PrintedPicture {
    QString caption;
    const Picture* picture = nullptr;  ///< owned by the FindPages from which it was made
};

/// Returns the pictures of @p pages in their order: those of cameras, then scans from above.
[[nodiscard]] std::vector<PrintedPicture> printedPictures(const FindPages& pages);

/// Returns the other evidence in @p pages in words, one line each: the newest CO2 of each trace, scans, poses
/// of robots, and the number of further pictures.
[[nodiscard]] QStringList evidenceLines(const FindPages& pages);

}  // namespace leitstand
