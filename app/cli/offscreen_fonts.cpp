#include "app/cli/offscreen_fonts.h"

#include <QGuiApplication>

namespace leitstand::cli {

OffscreenFonts::OffscreenFonts() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "leitstandctl";
    static char* arguments[] = {name, nullptr};
    m_application = std::make_unique<QGuiApplication>(count, arguments);
}

OffscreenFonts::~OffscreenFonts() = default;

}  // namespace leitstand::cli
