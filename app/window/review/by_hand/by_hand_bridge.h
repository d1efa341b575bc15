#pragma once

#include <filesystem>
#include <memory>

#include <QTimer>

#include "app/services/by_hand/map_by_hand.h"
#include "app/services/station/cameras/picture_feed.h"
#include "app/window/source/moment_source.h"
#include "core/base/result.h"

namespace leitstand {

/// The map of a mission that has ended, as the GUI thread sees it while somebody decides on it.
class ByHandBridge final : public MomentSource {
    Q_OBJECT
public:
    /// Reads the map, which takes a while. Errors as of MapByHand::open().
    [[nodiscard]] static Result<std::unique_ptr<ByHandBridge>> open(const std::filesystem::path& mission);
    ~ByHandBridge() override;

    /// Starts to notify a window of the map and of its changes. GUI thread.
    void begin();
    [[nodiscard]] MapByHand& hand() { return *m_hand; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const override { return m_hand->robots(); }
    [[nodiscard]] PictureFeed& pictures() override { return *m_pictures; }
    void watch(const std::string& /*robot*/) override {}  // an ended mission has no surroundings
    [[nodiscard]] SteadyTime arrivalOf(const ShownPicture& picture) const override;
    [[nodiscard]] GasTrend gas(const std::string& /*robot*/) const override { return {}; }

private:
    ByHandBridge();
    void tick();

    QTimer m_tick;                            ///< child of the bridge: moves with it to another thread
    std::unique_ptr<PictureFeed> m_pictures;  ///< without cameras
    std::unique_ptr<MapByHand> m_hand;        ///< last: its threads end first
};

}  // namespace leitstand
