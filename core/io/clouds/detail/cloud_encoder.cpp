#include "core/io/clouds/detail/cloud_encoder.h"

#include <cstring>

#include "core/io/detail/numbers.h"

namespace leitstand::detail {

namespace {

void appendBytes(std::string& bytes, float value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    bytes.append(raw, sizeof(raw));
}

}  // namespace

void appendRecord(std::string& bytes, const Scan& scan, std::size_t i, std::size_t labelBytes) {
    for (const float coordinate : scan.points[i]) appendBytes(bytes, coordinate);
    if (!scan.intensities.empty()) appendBytes(bytes, scan.intensities[i]);
    if (scan.labels.empty()) return;
    bytes += static_cast<char>(scan.labels[i]);
    bytes.append(labelBytes - 1, '\0');
}

void appendLine(std::string& text, const Scan& scan, std::size_t i) {
    const Eigen::Vector3f& point = scan.points[i];
    for (const float coordinate : point) {
        if (&coordinate != point.data()) text += ' ';
        appendNumber(text, coordinate);
    }
    if (!scan.intensities.empty()) {
        text += ' ';
        appendNumber(text, scan.intensities[i]);
    }
    if (!scan.labels.empty()) {
        text += ' ';
        text += static_cast<char>('0' + static_cast<int>(scan.labels[i]));
    }
    text += '\n';
}

}  // namespace leitstand::detail
