#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// A picture of the evidence as it is printed.
struct PrintedPicture {
    QString caption;
    const Picture* picture = nullptr;  ///< of the FindPages that it was made of
};

/// The pictures of @p pages in their order: of cameras, then scans from above.
[[nodiscard]] std::vector<PrintedPicture> printedPictures(const FindPages& pages);

/// The other evidence of @p pages in words, a line each: the newest CO2 of each trace, scans, where robots
/// stood.
[[nodiscard]] QStringList evidenceLines(const FindPages& pages);

}  // namespace leitstand
