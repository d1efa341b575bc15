#pragma once

#include <filesystem>
#include <memory>

#include <QObject>
#include <QString>

#include "app/services/comparison/map_comparing.h"

namespace leitstand {

/// The comparison of a review, for any of its windows. It continues while a window is created again in
/// another language.
class ReviewComparison final : public QObject {
    Q_OBJECT
public:
    /// Compares registrations of the mission @p folder.
    explicit ReviewComparison(std::filesystem::path folder);
    ~ReviewComparison() override;

    void begin(const ReviewIndexPtr& index, const RegistrationSettings& settings);
    /// Restores the result of an earlier review, if there is one.
    void recall(const ReviewIndexPtr& index);
    void cancel();
    void show(ComparedMap which) { m_shown = which; }

    [[nodiscard]] bool comparing() const { return m_comparing; }
    [[nodiscard]] double progress() const { return m_progress; }  ///< 0 to 1
    /// Settings that were used last.
    [[nodiscard]] const RegistrationSettings& settings() const { return m_settings; }
    [[nodiscard]] const ComparedMapsPtr& result() const { return m_result; }  ///< newest result; null: none
    [[nodiscard]] ComparedMap shown() const { return m_shown; }

signals:
    void progressed(double fraction);
    void changed();                      ///< the comparison began, ended, was cancelled or failed
    void finished(const QString& text);  ///< its result as text for the operator

private:
    void finish(const Result<ComparedMapsPtr>& result);
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    const std::filesystem::path m_folder;
    bool m_comparing = false;
    double m_progress = 0.0;
    RegistrationSettings m_settings;
    ComparedMapsPtr m_result;
    ComparedMap m_shown = ComparedMap::Recorded;
    std::unique_ptr<MapComparing> m_thread;  ///< the last member, so that it ends first
};

}  // namespace leitstand
