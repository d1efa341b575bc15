#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace leitstand::simulation {

/// The modules of a QR code, without the quiet zone around it.
struct QrCode {
    int edge = 0;             ///< number of modules on each side
    std::vector<char> black;  ///< row by row, edge * edge values

    [[nodiscard]] bool at(int row, int column) const {
        return black[static_cast<std::size_t>(row * edge + column)] != 0;
    }
};

inline constexpr std::size_t LongestQrText = 62;  ///< longest text [B]

/// Encodes @p text as a QR code by libqrencode (ISO/IEC 18004: model 2, versions 1 to 4, byte mode, error
/// correction M). An empty text is encoded as one space. Error when the text is longer than LongestQrText.
[[nodiscard]] Result<QrCode> encodeQr(std::string_view text);

}  // namespace leitstand::simulation
