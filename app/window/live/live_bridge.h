#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/session/station/picture_feed.h"
#include "app/session/station/station.h"
#include "app/window/live/live_moment.h"
#include "core/base/result.h"

namespace leitstand {

/// The station as the GUI thread sees it: what its threads tell arrives here as signals.
class LiveBridge final : public QObject {
    Q_OBJECT
public:
    /// Errors as of Station::open().
    [[nodiscard]] static Result<std::unique_ptr<LiveBridge>> open(const StationSettings& settings);
    ~LiveBridge() override;

    [[nodiscard]] Station& station() { return *m_station; }
    [[nodiscard]] PictureFeed& pictures() { return *m_pictures; }
    /// As of the newest tick.
    [[nodiscard]] const LiveMoment& moment() const { return m_moment; }
    /// Whose surroundings are asked for, ten times a second.
    void watch(const std::string& robot);

signals:
    void told(const QString& text);                        ///< for the operator, in English
    void pictured(const leitstand::ShownPicturePtr& one);  ///< of each camera the newest
    void mapChanged(const leitstand::MapPtr& map);
    void scansChanged(const leitstand::LiveMapPtr& map);  ///< the same map: which scans count, and why not
    void ticked(const leitstand::LiveMoment& moment);     ///< 30 times a second

private:
    LiveBridge();
    void tick();
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    QTimer m_tick;
    LiveMoment m_moment;
    std::string m_watched;
    std::optional<VirtualScanView> m_around;
    int m_sinceAround = 0;  ///< ticks
    std::unique_ptr<PictureFeed> m_pictures;
    std::unique_ptr<Station> m_station;  ///< last: its threads end first
};

}  // namespace leitstand
