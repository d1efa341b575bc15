#include "app/window/source/review_comparison.h"

#include <utility>

#include "widgets/models/review/comparison_rows.h"

namespace leitstand {

ReviewComparison::ReviewComparison(std::filesystem::path folder) : m_folder(std::move(folder)) {
    MapComparing::Listener listener;
    listener.onProgress = [this, reported = 0.0](double fraction) mutable {
        if (fraction >= reported && fraction < reported + 0.01) return;  // not a call for every point
        reported = fraction;
        hop([this, fraction] {
            m_progress = fraction;
            emit progressed(fraction);
        });
    };
    listener.onFinished = [this](const Result<ComparedMapsPtr>& result) {
        hop([this, result] { finish(result); });
    };
    listener.onMessage = [this](const std::string& text) {
        hop([this, text = QString::fromStdString(text)] { emit finished(text); });
    };
    m_thread = std::make_unique<MapComparing>(std::move(listener));
}

ReviewComparison::~ReviewComparison() = default;

void ReviewComparison::begin(const ReviewIndexPtr& index, const RegistrationSettings& settings) {
    if (m_comparing) return;
    m_comparing = true;
    m_progress = 0.0;
    m_settings = settings;
    m_thread->begin(m_folder, index, settings);
    emit changed();
}

void ReviewComparison::recall(const ReviewIndexPtr& index) {
    m_thread->recall(m_folder, index);
}

void ReviewComparison::cancel() {
    m_thread->cancel();
}

void ReviewComparison::finish(const Result<ComparedMapsPtr>& result) {
    const bool remembered = result && *result && (*result)->remembered;
    if (remembered && m_result) return;  // a newer one is there already
    if (!remembered) m_comparing = false;
    if (result && *result) {
        m_result = *result;
        if (!m_comparing) m_settings = m_result->comparison->settings;
    }
    emit changed();
    if (remembered) return;
    if (!result) return emit finished(QString::fromStdString(result.error().text));
    emit finished(*result ? comparedText(*(*result)->comparison) : tr("Registering again was cancelled"));
}

}  // namespace leitstand
