#include "app/window/source/review_report.h"

#include <exception>
#include <utility>

#include <QCoreApplication>

#include "app/report/pdf/pdf_report.h"
#include "app/services/handin/writing/report_messages.h"
#include "app/services/handin/writing/report_writer.h"

namespace leitstand {
namespace {

constexpr double Step = 0.05;  ///< step of the reported progress

}  // namespace

ReviewReport::ReviewReport(std::filesystem::path folder) : m_mission(std::move(folder)) {}

ReviewReport::~ReviewReport() = default;

void ReviewReport::begin(const QString& out) {
    if (m_writing) return;
    m_writing = true;
    m_progress = 0.0;
    m_thread = {};  // ends the thread before, which reads m_out
    m_out = out;
    m_thread =
        std::jthread([this, attempt = ++m_attempt](const std::stop_token& stop) { run(stop, attempt); });
    emit changed();
    emit notified(tr("The report is being written into %1").arg(out));
}

void ReviewReport::beginAround(const std::function<void()>& change) {
    m_thread = {};  // asked to stop, and waited for
    ++m_attempt;
    change();
    if (!std::exchange(m_writing, false)) return;
    begin(m_out);
}

void ReviewReport::run(const std::stop_token& stop, int attempt) {
    const std::string out = m_out.toStdString();
    ReportOptions options;
    options.pdf = &pdfOf;
    options.version = QCoreApplication::applicationVersion().toStdString();
    const auto report = [this, attempt, reported = 0.0](double fraction) mutable {
        if (fraction < reported + Step) return;
        reported = fraction;
        hop([this, fraction, attempt] {
            if (attempt != m_attempt) return;
            m_progress = fraction;
            emit changed();
        });
    };
    QStringList words;
    try {
        const auto done = writeReport(m_mission, out, options, {report, stop});
        for (const std::string& text : ReportMessages().of(done, out))
            words.append(QString::fromStdString(text));
    } catch (const std::exception& problem) {
        words = {QString::fromLocal8Bit(problem.what())};
    }
    hop([this, words, attempt] { finish(attempt, words); });
}

void ReviewReport::finish(int attempt, const QStringList& words) {
    if (attempt != m_attempt) return;
    m_writing = false;
    emit changed();
    for (const QString& text : words) emit notified(text);
}

}  // namespace leitstand
