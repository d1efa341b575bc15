#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// A QR code in a picture.
struct FoundCode {
    std::string text;                        ///< its text; without control characters, at most 512 bytes
    std::array<Eigen::Vector2d, 4> corners;  ///< its corners, in the order of ZBar [px]
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< middle of the code [px]
    double size = 0.0;                                 ///< square root of its area [px]
};

/// Reads QR codes (ZBar). Pictures up to 800 pixels wide are also read after enlarging, to find small codes.
/// One thread.
class CodeReader {
public:
    CodeReader();
    ~CodeReader();
    CodeReader(CodeReader&&) noexcept;
    CodeReader& operator=(CodeReader&&) noexcept;

    /// Returns the codes in @p picture, each text once. Reads colours and grey of 8 bits; finds nothing in
    /// other pictures.
    [[nodiscard]] std::vector<FoundCode> read(const Picture& picture);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
