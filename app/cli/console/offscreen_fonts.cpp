#include "app/cli/console/offscreen_fonts.h"

#include <QGuiApplication>
#include <QLocale>

namespace leitstand::cli {

OffscreenFonts::OffscreenFonts() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "leitstandctl";
    static char* arguments[] = {name, nullptr};
    m_application = std::make_unique<QGuiApplication>(count, arguments);
    QLocale::setDefault(QLocale::c());  // output is English on every computer
}

OffscreenFonts::~OffscreenFonts() = default;

}  // namespace leitstand::cli
