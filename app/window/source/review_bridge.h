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

/// A mission's log for the GUI thread. Its moments arrive here as signals.
class ReviewBridge final : public MomentSource {
    Q_OBJECT
public:
    /// Opens the log of @p mission. Errors are those of ReviewPlayer::open().
    [[nodiscard]] static Result<std::unique_ptr<ReviewBridge>> open(const std::filesystem::path& mission);
    ~ReviewBridge() override;

    [[nodiscard]] ReviewPlayer& player() { return *m_player; }
    /// Returns the pen, which has everything that was written in this review, in any of its windows.
    [[nodiscard]] const ReviewPen& pen() const { return *m_pen; }
    /// Calls @p what on the writing thread, after all earlier calls. Then emits wrote() with @p done, or with
    /// the error, on the GUI thread.
    void write(std::function<Result<void>(ReviewPen&)> what, const QString& done);
    [[nodiscard]] ReviewComparison& comparison() const { return *m_comparison; }
    [[nodiscard]] ReviewReport& report() const { return *m_report; }
    /// Writes the hand-in to @p folder, including everything that was passed to write() before.
    void reportInto(const QString& folder);
    [[nodiscard]] bool reporting() const;  ///< true from the request until it is done
    /// Shows @p map in panes, instead of the moment's map. Null: the moment's map again.
    void showInstead(MapPtr map);
    /// Emits the present state again, for a window that was just created.
    void showAgain();
    [[nodiscard]] const ReviewIndexPtr& index() const { return m_index; }      ///< null: still being read
    [[nodiscard]] const ReviewMomentPtr& reviewed() const { return m_shown; }  ///< null: there was none yet

    [[nodiscard]] const std::vector<RobotDescription>& robots() const override { return m_player->robots(); }
    [[nodiscard]] PictureFeed& pictures() override { return *m_pictures; }
    void watch(const std::string& robot) override;
    [[nodiscard]] SteadyTime arrivalOf(const ShownPicture& picture) const override;
    /// From the usual rate of the camera's pictures in this mission's log, which may have only some of them.
    [[nodiscard]] FreshnessLimits pictureLimits(const std::string& robot,
                                                const std::string& sensor) const override;
    [[nodiscard]] ScanSource scanSource(const std::string& robot) const override;
    /// Taken from the log, so that it is right after a jump.
    [[nodiscard]] ValueTrend gas(const std::string& robot) const override;
    [[nodiscard]] ValueTrend reading(const std::string& robot, const std::string& topic,
                                     std::size_t index) const override;

signals:
    /// A write() has ended, no matter which window requested it. @p done: its text. @p problem: the error;
    /// empty: none.
    void wrote(const QString& done, const QString& problem);
    void opening(double fraction);                        ///< share of the mission that was read, 0 to 1
    void opened(const leitstand::ReviewIndexPtr& index);  ///< the whole mission was read

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
    MapPtr m_instead;        ///< map that is shown instead of the moment's map; null: none
    int m_reportsAsked = 0;  ///< number of requested reports that have not begun
    bool m_again = false;    ///< whether a picture arrived after its moment was shown
    std::string m_watched;
    std::map<std::string, std::uint64_t> m_fed;  ///< sequences of pictures and calibrations, by topic
    std::unique_ptr<PictureFeed> m_pictures;
    std::unique_ptr<ReviewPen> m_pen;
    std::unique_ptr<ReviewComparison> m_comparison;
    std::unique_ptr<ReviewReport> m_report;
    std::unique_ptr<ReviewPlayer> m_player;  ///< its thread must end before what it notifies is destroyed
    JobQueue m_writing;
    std::jthread m_writer;  ///< the last member, so that it ends first, after everything is written
};

}  // namespace leitstand
