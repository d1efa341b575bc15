#pragma once

#include <memory>

class QGuiApplication;

namespace leitstand::cli {

/// Owns the QGuiApplication that Qt needs to lay out text without a display. Only one may exist at a time, in
/// the main thread. Also sets the default QLocale to C.
class OffscreenFonts {
public:
    OffscreenFonts();
    ~OffscreenFonts();
    OffscreenFonts(const OffscreenFonts&) = delete;
    OffscreenFonts& operator=(const OffscreenFonts&) = delete;

private:
    std::unique_ptr<QGuiApplication> m_application;
};

}  // namespace leitstand::cli
