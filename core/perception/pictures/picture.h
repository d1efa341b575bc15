#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace leitstand {

/// A decoded picture. Rows follow each other without gaps; values are in the machine's byte order.
struct Picture {
    enum class Pixel : std::uint8_t {
        Grey8,
        Rgb8,    ///< red, green, blue
        Grey16,  ///< unsigned values
        Float32
    };
    int width = 0, height = 0;  ///< [px]
    Pixel pixel = Pixel::Grey8;
    std::vector<std::byte> bytes;  ///< width * height * pixelSize()

    [[nodiscard]] std::size_t pixelSize() const {
        switch (pixel) {
            case Pixel::Grey8:
                return 1;
            case Pixel::Rgb8:
                return 3;
            case Pixel::Grey16:
                return 2;
            case Pixel::Float32:
                return 4;
        }
        return 1;
    }
};

/// Temperatures of a thermal picture.
struct ThermalPicture {
    int width = 0, height = 0;   ///< [px]
    std::vector<float> celsius;  ///< row by row [degrees C]; NaN where the camera measures nothing
};

}  // namespace leitstand
