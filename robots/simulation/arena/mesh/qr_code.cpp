#include "robots/simulation/arena/mesh/qr_code.h"

#include <cstddef>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <qrencode.h>

namespace leitstand::simulation {

Result<QrCode> encodeQr(std::string_view text) {
    if (text.size() > LongestQrText)
        return Error{
            fmt::format("a QR code: expected at most {} bytes, found {}", LongestQrText, text.size())};
    const std::string bytes(text.empty() ? " " : text);  // no QR code holds an empty text
    const std::unique_ptr<QRcode, void (*)(QRcode*)> made(
        QRcode_encodeData(static_cast<int>(bytes.size()),
                          reinterpret_cast<const unsigned char*>(bytes.data()), 0, QR_ECLEVEL_M),
        &QRcode_free);
    if (!made) return Error{fmt::format("a QR code of {} bytes cannot be made", bytes.size())};
    QrCode code;
    code.edge = made->width;
    const auto modules = static_cast<std::size_t>(code.edge) * static_cast<std::size_t>(code.edge);
    code.black.reserve(modules);
    for (std::size_t i = 0; i < modules; ++i)
        code.black.push_back(static_cast<char>(made->data[i] & 1U));  // lowest bit: black
    return code;
}

}  // namespace leitstand::simulation
