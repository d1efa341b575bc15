#pragma once

#include <filesystem>
#include <memory>

#include <QTimer>

#include "app/services/by_hand/map_by_hand.h"
#include "app/services/station/cameras/picture_feed.h"
#include "app/window/source/moment_source.h"
#include "core/base/result.h"

namespace leitstand {

/// The map of a mission that has ended, for the GUI thread, while somebody makes decisions about it.
class ByHandBridge final : public MomentSource {
    Q_OBJECT
public:
    /// Reads the map, which takes a while. Errors are those of MapByHand::open().
    [[nodiscard]] static Result<std::unique_ptr<ByHandBridge>> open(const std::filesystem::path& mission);
    ~ByHandBridge() override;

    /// Begins to notify a window about the map and its changes. GUI thread.
    void begin();
    [[nodiscard]] MapByHand& hand() { return *m_hand; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const override { return m_hand->robots(); }
    [[nodiscard]] PictureFeed& pictures() override { return *m_pictures; }
    void watch(const std::string& /*robot*/) override {}  // an ended mission has no surroundings
    [[nodiscard]] SteadyTime arrivalOf(const ShownPicture& picture) const override;
    [[nodiscard]] ValueTrend gas(const std::string& /*robot*/) const override { return {}; }
    [[nodiscard]] ValueTrend reading(const std::string& /*robot*/, const std::string& /*topic*/,
                                     std::size_t /*index*/) const override {
        return {};
    }

private:
    ByHandBridge();
    void tick();

    QTimer m_tick;                            ///< child of the bridge: moves with it to another thread
    std::unique_ptr<PictureFeed> m_pictures;  ///< without cameras
    std::unique_ptr<MapByHand> m_hand;        ///< the last member, so that its threads end first
};

}  // namespace leitstand
