#pragma once

#include <map>
#include <string>
#include <utility>

#include "app/services/station/cameras/picture_feed.h"
#include "widgets/camera/picture_image.h"

namespace leitstand {

/// Holds how pictures are shown: contrast, unwrapping and infrared colours. They are the same for all
/// cameras.
class PictureLooks {
public:
    [[nodiscard]] const PictureLook& look() const { return m_look; }
    void nextContrast();  ///< off, gentle, strong, and off again
    void setUnwrapped(bool unwrapped) { m_look.unwrapped = unwrapped; }

    [[nodiscard]] ThermalPalette palette() const { return m_palette; }
    void setPalette(ThermalPalette palette) { m_palette = palette; }
    [[nodiscard]] bool autoRange() const { return m_autoRange; }
    void setAutoRange(bool on);
    /// Returns the range of temperatures of the colours for a new @p picture from the camera @p sensor of
    /// @p robot. It is fixed, or with autoRange() follows what the pictures show.
    [[nodiscard]] ThermalRange rangeFor(const std::string& robot, const std::string& sensor,
                                        const ThermalPicture& picture);

private:
    PictureLook m_look{ContrastHelp::Off, true};
    ThermalPalette m_palette = ThermalPalette::Iron;
    bool m_autoRange = false;
    std::map<std::pair<std::string, std::string>, ThermalRange> m_ranges;  ///< ranges of the last pictures
};

}  // namespace leitstand
