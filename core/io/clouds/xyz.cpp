#include "core/io/clouds/xyz.h"

#include <string>
#include <utility>

#include "core/io/clouds/detail/cloud_encoder.h"
#include "core/io/clouds/detail/point_text.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

Result<ScanReading> readXyz(const std::filesystem::path& file) {
    return detail::readPointText(file,
                                 {.separators = detail::Separators::BlanksAndCommas, .columnNames = true});
}

Result<void> writeXyz(const std::filesystem::path& file, const Scan& scan) {
    auto created = detail::OutputFile::create(file);
    if (!created) return created.error();
    detail::OutputFile out = std::move(created).value();
    std::string line = "# x y z";
    if (!scan.intensities.empty()) line += " intensity";
    if (!scan.labels.empty()) line += " label";
    line += '\n';
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        detail::appendLine(line, scan, i);
        out.write(line);
        line.clear();
    }
    return out.commit();
}

}  // namespace leitstand
