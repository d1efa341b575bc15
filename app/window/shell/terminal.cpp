#include "app/window/shell/terminal.h"

#include <cstdio>
#include <string>

#include <QString>

#include "core/base/printable.h"

namespace leitstand {
namespace {

void tellLine(const std::string& line, std::FILE* stream = stderr) {
    std::fprintf(stream, "%s\n", printable(line).c_str());
}

void tellQt(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    tellLine(qFormatLogMessage(type, context, text).toStdString());
}

void dropPlatformRemarks(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    for (const char* remark : {"propagateSizeHints", "XDG_RUNTIME_DIR not set"}) {
        if (text.contains(QLatin1String(remark))) return;
    }
    tellQt(type, context, text);
}

}  // namespace

void tellTerminal(std::string_view text) {
    tellLine("leitstand: " + std::string(text));
}

void sayOnTerminal(std::string_view text) {
    tellLine("leitstand: " + std::string(text), stdout);
    std::fflush(stdout);
}

void tellQtMessages(bool picture) {
    qInstallMessageHandler(picture ? dropPlatformRemarks : tellQt);
}

}  // namespace leitstand
