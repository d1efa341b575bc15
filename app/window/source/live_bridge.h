#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include <QTimer>

#include "app/services/station/cameras/picture_feed.h"
#include "app/services/station/station.h"
#include "app/window/source/moment_source.h"
#include "core/base/result.h"

namespace leitstand {

/// The station for the GUI thread. What the station's threads report arrives here as signals.
class LiveBridge final : public MomentSource {
    Q_OBJECT
public:
    /// Opens the station. Errors are those of Station::open().
    [[nodiscard]] static Result<std::unique_ptr<LiveBridge>> open(const StationSettings& settings);
    ~LiveBridge() override;

    /// Emits the present map again, for a window that was just created.
    void showAgain();
    [[nodiscard]] Station& station() { return *m_station; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const override;
    [[nodiscard]] PictureFeed& pictures() override { return *m_pictures; }
    /// From now on, updates this robot's surroundings at 10 to 15 Hz.
    void watch(const std::string& robot) override;
    [[nodiscard]] SteadyTime arrivalOf(const ShownPicture& picture) const override;
    [[nodiscard]] ValueTrend gas(const std::string& robot) const override;
    [[nodiscard]] ValueTrend reading(const std::string& robot, const std::string& topic,
                                     std::size_t index) const override;

private:
    LiveBridge();
    void tick();
    void keepTrends();
    void lookAround();  ///< updates m_around, sooner after a new scan
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    QTimer m_tick;
    std::string m_watched;
    std::map<std::string, ValueTrend> m_gas;  ///< by robot
    /// By robot and topic: a trend for each of its readings.
    std::map<std::pair<std::string, std::string>, std::vector<ValueTrend>> m_readings;
    std::optional<VirtualScanView> m_around;
    int m_sinceAround = 0;                ///< number of ticks
    std::optional<SteadyTime> m_scanned;  ///< when the newest data in m_around arrived
    std::unique_ptr<PictureFeed> m_pictures;
    std::unique_ptr<Station> m_station;  ///< the last member, so that its threads end first
};

}  // namespace leitstand
