#pragma once

#include <cstddef>
#include <string>

#include "core/cloud/scan.h"

namespace leitstand::detail {

/// Appends point @p i, its intensity and its label as little-endian numbers. The label takes @p labelBytes
/// bytes.
void appendRecord(std::string& bytes, const Scan& scan, std::size_t i, std::size_t labelBytes);

/// Appends point @p i with its intensity and label as a line of text. Reading the text gives exactly the same
/// values.
void appendLine(std::string& text, const Scan& scan, std::size_t i);

}  // namespace leitstand::detail
