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

/// The station as the GUI thread sees it. What its threads report arrives here as signals.
class LiveBridge final : public MomentSource {
    Q_OBJECT
public:
    /// Opens the station. Errors as of Station::open().
    [[nodiscard]] static Result<std::unique_ptr<LiveBridge>> open(const StationSettings& settings);
    ~LiveBridge() override;

    /// Emits the present map again, for a new window.
    void showAgain();
    [[nodiscard]] Station& station() { return *m_station; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const override;
    [[nodiscard]] PictureFeed& pictures() override { return *m_pictures; }
    void watch(const std::string& robot) override;  ///< updates the robot's surroundings at 10 to 15 Hz
    [[nodiscard]] SteadyTime arrivalOf(const ShownPicture& picture) const override;
    [[nodiscard]] GasTrend gas(const std::string& robot) const override;

private:
    LiveBridge();
    void tick();
    void keepGas();
    void lookAround();  ///< updates m_around, sooner after a new scan
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    QTimer m_tick;
    std::string m_watched;
    std::map<std::string, GasTrend> m_gas;  ///< by robot
    std::optional<VirtualScanView> m_around;
    int m_sinceAround = 0;                ///< ticks
    std::optional<SteadyTime> m_scanned;  ///< arrival of the newest data in m_around
    std::unique_ptr<PictureFeed> m_pictures;
    std::unique_ptr<Station> m_station;  ///< last: its threads end first
};

}  // namespace leitstand
