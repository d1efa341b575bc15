#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include <QTimer>

#include "app/services/job_queue.h"
#include "app/services/review/playing/review_player.h"
#include "app/services/review/review_pen.h"
#include "app/window/source/moment_source.h"
#include "core/base/result.h"

namespace leitstand {

class ReviewComparison;
class ReviewReport;

/// A mission's log as the GUI thread sees it. Its moments arrive here as signals.
class ReviewBridge final : public MomentSource {
    Q_OBJECT
public:
    /// Opens the log of @p mission. Errors as of ReviewPlayer::open().
    [[nodiscard]] static Result<std::unique_ptr<ReviewBridge>> open(const std::filesystem::path& mission);
    ~ReviewBridge() override;

    [[nodiscard]] ReviewPlayer& player() { return *m_player; }
    /// Returns the pen with what is written in this review, in whatever window.
    [[nodiscard]] const ReviewPen& pen() const { return *m_pen; }
    /// Calls @p what on a thread of its own, in order, then emits wrote() with @p done on the GUI thread.
    void write(std::function<Result<void>(ReviewPen&)> what, const QString& done);
    [[nodiscard]] ReviewComparison& comparison() const { return *m_comparison; }
    [[nodiscard]] ReviewReport& report() const { return *m_report; }
    /// Writes the hand-in into @p folder, with all that was written before.
    void reportInto(const QString& folder);
    [[nodiscard]] bool reporting() const;  ///< from the request until it is done
    /// Shows @p map to panes in place of that of the moment. Null: the moment's again.
    void showInstead(MapPtr map);
    /// Notifies a new window of everything that was notified before.
    void showAgain();
    [[nodiscard]] const ReviewIndexPtr& index() const { return m_index; }      ///< null: still being read
    [[nodiscard]] const ReviewMomentPtr& reviewed() const { return m_shown; }  ///< null before the first

    [[nodiscard]] const std::vector<RobotDescription>& robots() const override { return m_player->robots(); }
    [[nodiscard]] PictureFeed& pictures() override { return *m_pictures; }
    void watch(const std::string& robot) override;
    [[nodiscard]] SteadyTime arrivalOf(const ShownPicture& picture) const override;
    /// By their usual rate in this mission, which may have kept only some of them.
    [[nodiscard]] FreshnessLimits pictureLimits(const std::string& robot,
                                                const std::string& sensor) const override;
    [[nodiscard]] ScanSource scanSource(const std::string& robot) const override;
    /// Taken from the log, so that it is right after a jump.
    [[nodiscard]] GasTrend gas(const std::string& robot) const override;

signals:
    /// Something was written, requested in whatever window: @p done, or the error in @p problem.
    void wrote(const QString& done, const QString& problem);
    void opening(double fraction);                        ///< how far the mission is read through
    void opened(const leitstand::ReviewIndexPtr& index);  ///< the mission is read through

private:
    ReviewBridge();
    void tick();
    void showPictures(const ReviewMoment& moment);
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    QTimer m_tick;
    ReviewIndexPtr m_index;
    ReviewMomentPtr m_shown;
    MapPtr m_instead;        ///< shown in place of the moment's map; null: none
    int m_reportsAsked = 0;  ///< requested reports that have not begun
    bool m_again = false;    ///< a picture came after its moment was shown
    std::string m_watched;
    std::map<std::string, std::uint64_t> m_fed;  ///< sequences of pictures and calibrations, by topic
    std::unique_ptr<PictureFeed> m_pictures;
    std::unique_ptr<ReviewPen> m_pen;
    std::unique_ptr<ReviewComparison> m_comparison;
    std::unique_ptr<ReviewReport> m_report;
    std::unique_ptr<ReviewPlayer> m_player;  ///< its thread ends before what it notifies is destroyed
    JobQueue m_writing;
    std::jthread m_writer;  ///< last: ends first, when all is written
};

}  // namespace leitstand
