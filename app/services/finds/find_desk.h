#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/services/finds/freezing.h"
#include "app/services/finds/mode_book.h"
#include "app/services/finds/recent_evidence.h"
#include "app/services/job_queue.h"
#include "app/services/log/event_sink.h"
#include "core/base/result.h"
#include "core/mission/finds/find_book.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Where something that a picture shows is.
struct PlacedFind {
    std::uint64_t scan = 0;                           ///< key scan it hangs on; 0: none
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< [m]
    double deviation = Unknown;                       ///< [m]
};

/// What a FindDesk works with. All may be called on any thread.
struct FindDeskSetup {
    using Located = std::function<void(const std::optional<PlacedFind>&)>;
    std::vector<RobotDescription> robots = {};
    std::string station = {};  ///< persistent identity
    std::function<MissionStatePtr()> mission = {};
    std::function<Result<void>(const VictimSample&)> say = {};
    std::function<Result<void>(const CandidateSample&)> sayCandidate = {};
    std::function<Result<void>(const UndoSample&)> undo = {};
    /// Asks where what @p chosen shows is; answers once, on whatever thread. Empty: nowhere.
    std::function<void(const ChosenEvidence& chosen, Located answer)> locate = {};
    using Shown = std::function<void(const std::vector<bool>&)>;
    /// Asks which of @p pictures show the place @p inMap [m]; answers once, on whatever thread.
    std::function<void(std::vector<Event> pictures, const Eigen::Vector3d& inMap, Shown answer)> shows = {};
    /// Where a robot is in the map now; empty: nobody knows.
    std::function<std::optional<Pose>(const std::string& robot)> robotInMap = {};
    std::function<void(const std::string&)> tell = {};  ///< for the operator, in words
    std::function<Time()> now = {};                     ///< station's clock
};

/// Files what the operator finds: freezes evidence, confirms, changes and takes back. Everything is an entry
/// of the log. Any thread.
class FindDesk : public EventSink {
public:
    explicit FindDesk(FindDeskSetup setup);
    ~FindDesk() override { finish(); }

    void onEvent(const Event& event) override {
        m_recent.onEvent(event);
        m_modes.onEvent(event);
    }
    void finish();  ///< waits until all that was frozen is filed

    /// Freezes what @p robot saw in the last seconds as a find of @p kind: at @p at in a picture, else, for a
    /// victim, at the hot spot, else where the camera @p looksThrough looks. A find that is there already is
    /// joined.
    void freeze(const std::string& robot, VictimSample::Kind kind, const std::string& looksThrough,
                const std::optional<PicturePoint>& at = std::nullopt);
    /// The same at a place on the map [m] that the operator pointed to.
    void freezeAt(const std::string& robot, VictimSample::Kind kind, const Eigen::Vector3d& placeInMap);
    /// What was frozen last; empty: nothing yet.
    [[nodiscard]] std::optional<FindKey> newest() const;
    /// What was frozen last and nobody has confirmed or discarded since.
    [[nodiscard]] std::optional<FindKey> unconfirmed();
    [[nodiscard]] bool isFiling() const;  ///< something is frozen whose place is still searched
    /// The second press: confirms what is unconfirmed(), or what is being filed as soon as it is.
    Result<void> confirmNewest();
    [[nodiscard]] std::uint64_t filings() const;  ///< how often something was filed: rises with newest()

    /// Files @p candidate with its cues and with what its robots see there now, as soon as that is looked
    /// through.
    Result<void> fileCandidate(std::uint32_t candidate);
    /// @p candidate is none: it stays off the list, also when it is seen again.
    Result<void> dismiss(std::uint32_t candidate);
    Result<void> confirm(const FindKey& find);
    Result<void> discard(const FindKey& find);
    Result<void> merge(const FindKey& find, std::uint32_t into);
    Result<void> move(const FindKey& find, const Eigen::Vector3d& floorInMap);
    /// The form of @p form's find as the operator filled it in: signs, situation, tag, area, text. All else
    /// of the find stays as it is.
    Result<void> edit(const VictimSample& form);
    /// Takes back this station's newest entry on a find or a candidate; an error when there is none.
    Result<void> undo();

private:
    /// The mission with all that was said here, which may still be on its way into it; with m_filing held.
    [[nodiscard]] MissionStatePtr known();
    Result<void> keep(const VictimSample& sample);    ///< says it; likewise
    void submitFiling(std::function<void()> filing);  ///< for the worker; it isFiling() until then
    [[nodiscard]] bool filedLast() const;
    void file(FrozenEvidence frozen, VictimSample::Kind kind);
    void locate(ChosenEvidence chosen, VictimSample::Kind kind);
    void file(const CandidateSample& candidate, const FrozenEvidence& seen);
    /// What @p recent of @p robot shows of @p inMap [m]; empty: it looks elsewhere, or said nothing of late.
    [[nodiscard]] std::optional<FrozenEvidence> look(const RobotDescription& robot,
                                                     const RobotEvidence& recent,
                                                     const Eigen::Vector3d& inMap, Time pressed) const;
    /// Says @p sample, tells the operator, and that @p candidates are filed by it; with m_filing held.
    Result<void> enter(const VictimSample& sample, bool joined,
                       const std::vector<CandidateSample>& candidates);
    [[nodiscard]] const RobotDescription* robot(const std::string& name) const;
    Result<void> say(const std::optional<VictimSample>& sample, const FindKey& find);

    const FindDeskSetup m_setup;
    RecentEvidence m_recent;
    ModeBook m_modes;
    mutable std::mutex m_mutex;
    std::mutex m_filing;  ///< entries are made one after the other
    std::optional<FindKey> m_newest;
    std::uint64_t m_filings = 0;
    int m_awaited = 0;                 ///< filings that the worker has not done yet
    bool m_filedLast = false;          ///< something came of the last that it did
    std::vector<VictimSample> m_said;  ///< that the mission may not have yet; under m_filing
    JobQueue m_queue;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
