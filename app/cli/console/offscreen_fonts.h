#pragma once

#include <memory>

class QGuiApplication;

namespace leitstand::cli {

/// What Qt needs to lay text out, without a display: one while it lives, in the main thread.
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
