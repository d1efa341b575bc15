#include "app/window/shell/terminal.h"

#include <cstdio>
#include <string>

#include <QString>

#include "core/base/printable.h"

namespace leitstand {
namespace {

void printLine(const std::string& line, std::FILE* stream = stderr) {
    std::fprintf(stream, "%s\n", printable(line).c_str());
}

void notifyQt(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    printLine(qFormatLogMessage(type, context, text).toStdString());
}

void dropPlatformRemarks(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    for (const char* remark : {"propagateSizeHints", "XDG_RUNTIME_DIR not set"}) {
        if (text.contains(QLatin1String(remark))) return;
    }
    notifyQt(type, context, text);
}

}  // namespace

void printProblem(std::string_view text) {
    printLine("leitstand: " + std::string(text));
}

void printNotice(std::string_view text) {
    printLine("leitstand: " + std::string(text), stdout);
    std::fflush(stdout);
}

void printQtMessages(bool picture) {
    qInstallMessageHandler(picture ? dropPlatformRemarks : notifyQt);
}

}  // namespace leitstand
