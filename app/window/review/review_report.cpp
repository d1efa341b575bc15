#include "app/window/review/review_report.h"

#include <exception>
#include <utility>

#include <QCoreApplication>

#include "app/report/pdf_report.h"
#include "app/session/report/report_telling.h"
#include "app/session/report/report_writer.h"

namespace leitstand {
namespace {

constexpr double Step = 0.05;  ///< of the progress that is told

}  // namespace

ReviewReport::ReviewReport(std::filesystem::path folder) : m_mission(std::move(folder)) {}

ReviewReport::~ReviewReport() = default;

void ReviewReport::begin(const QString& out) {
    if (m_writing) return;
    m_writing = true;
    m_progress = 0.0;
    m_thread = std::jthread([this, out](const std::stop_token& stop) { run(stop, out); });
    emit changed();
    emit told(tr("The report is being written into %1").arg(out));
}

void ReviewReport::run(const std::stop_token& stop, const QString& out) {
    ReportOptions options;
    options.pdf = &pdfOf;
    options.version = QCoreApplication::applicationVersion().toStdString();
    const auto report = [this, told = 0.0](double fraction) mutable {
        if (fraction < told + Step) return;
        told = fraction;
        hop([this, fraction] {
            m_progress = fraction;
            emit changed();
        });
    };
    QStringList words;
    try {
        const auto done = writeReport(m_mission, out.toStdString(), options, {report, stop});
        for (const std::string& text : ReportTelling().of(done, out.toStdString()))
            words.append(QString::fromStdString(text));
    } catch (const std::exception& problem) {
        words = {QString::fromLocal8Bit(problem.what())};
    }
    hop([this, words] { finish(words); });
}

void ReviewReport::finish(const QStringList& words) {
    m_writing = false;
    emit changed();
    for (const QString& text : words) emit told(text);
}

}  // namespace leitstand
