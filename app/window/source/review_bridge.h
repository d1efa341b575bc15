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

/// A mission's log as the GUI thread sees it: its moments arrive here as signals.
class ReviewBridge final : public MomentSource {
    Q_OBJECT
public:
    /// Errors as of ReviewPlayer::open().
    [[nodiscard]] static Result<std::unique_ptr<ReviewBridge>> open(const std::filesystem::path& mission);
    ~ReviewBridge() override;

    [[nodiscard]] ReviewPlayer& player() { return *m_player; }
    /// What is written in this review, whatever window it is written in.
    [[nodiscard]] const ReviewPen& pen() const { return *m_pen; }
    /// Writes on a thread of its own, in order: @p what there, then wrote() with @p done here.
    void write(std::function<Result<void>(ReviewPen&)> what, const QString& done);
    [[nodiscard]] ReviewComparison& comparison() const { return *m_comparison; }
    [[nodiscard]] ReviewReport& report() const { return *m_report; }
    /// Writes the hand-in into @p folder, with all that was written before.
    void reportInto(const QString& folder);
    [[nodiscard]] bool reporting() const;  ///< from being asked until it is over
    /// Panes see @p map in place of that of the moment; null: the moment's again.
    void showInstead(MapPtr map);
    /// Tells a new window everything that was told before.
    void showAgain();
    [[nodiscard]] const ReviewIndexPtr& index() const { return m_index; }      ///< null: still read through
    [[nodiscard]] const ReviewMomentPtr& reviewed() const { return m_shown; }  ///< null before the first

    [[nodiscard]] const std::vector<RobotDescription>& robots() const override { return m_player->robots(); }
    [[nodiscard]] PictureFeed& pictures() override { return *m_pictures; }
    void watch(const std::string& robot) override;
    [[nodiscard]] SteadyTime arrivalOf(const ShownPicture& picture) const override;
    /// By how often they came in this mission, which may have kept a choice of them.
    [[nodiscard]] FreshnessLimits pictureLimits(const std::string& robot,
                                                const std::string& sensor) const override;
    [[nodiscard]] ScanSource scanSource(const std::string& robot) const override;
    /// As the log holds it: also after a jump.
    [[nodiscard]] GasTrend gas(const std::string& robot) const override;

signals:
    /// Something was written, in whatever window it was asked for: @p done, or what is wrong in @p problem.
    void wrote(const QString& done, const QString& problem);
    void opening(double fraction);                        ///< how far the mission is read through
    void opened(const leitstand::ReviewIndexPtr& index);  ///< it is

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
    MapPtr m_instead;        ///< of the moment's map; null: none
    int m_reportsAsked = 0;  ///< that have not begun
    bool m_again = false;    ///< a picture came after its moment was shown
    std::string m_watched;
    std::map<std::string, std::uint64_t> m_fed;  ///< sequences of pictures and calibrations, by topic
    std::unique_ptr<PictureFeed> m_pictures;
    std::unique_ptr<ReviewPen> m_pen;
    std::unique_ptr<ReviewComparison> m_comparison;
    std::unique_ptr<ReviewReport> m_report;
    std::unique_ptr<ReviewPlayer> m_player;  ///< its thread ends before what it tells
    JobQueue m_writing;
    std::jthread m_writer;  ///< last: ends first, when all is written
};

}  // namespace leitstand
