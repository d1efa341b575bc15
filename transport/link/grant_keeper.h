#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/robot/control/grant_book.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Returns the QoS of grants: reliable, transient local, as for all topics below /leitstand/.
[[nodiscard]] Qos grantQos();

/// Callbacks on the keeper's own thread. No lock is held, so they may call the keeper, but not destroy it.
struct GrantListener {
    std::function<void()> onChange = {};                      ///< the result of view() or mayAct() changed
    std::function<void(std::vector<HeldGrant>)> onHeld = {};  ///< held grants changed: store them
};

/// A station's grants over DDS (GrantBook): heartbeats, requests and answers on /leitstand/grants. Drive
/// commands and releases must come from the same node; otherwise robots do not accept them as the holder's.
/// Any thread; nothing waits for the network.
class GrantKeeper {
public:
    /// Holds the grants in StationIdentity::held again at once. Error when the node may not publish grants (a
    /// viewer in a secured domain).
    [[nodiscard]] static Result<std::unique_ptr<GrantKeeper>> create(Node& node, const StationIdentity& me,
                                                                     GrantListener listener = {},
                                                                     const GrantTiming& timing = {});
    /// Releases all grants without calling the listener, so the stored grants are not changed.
    ~GrantKeeper();
    GrantKeeper(const GrantKeeper&) = delete;
    GrantKeeper& operator=(const GrantKeeper&) = delete;

    /// See GrantBook::rejoined(). Call it before anything is sent or received with the new identity
    /// (Node::rejoin()).
    void rejoined(const Guid& participant);
    void requestGrant(const GrantId& id);
    void release(const GrantId& id);  ///< also withdraws a request
    void answerRequest(const GrantId& id, bool consent);

    [[nodiscard]] GrantView view(const GrantId& id) const;
    [[nodiscard]] bool mayAct(const GrantId& id) const;
    [[nodiscard]] std::vector<HeldGrant> held() const;

private:
    struct State;
    explicit GrantKeeper(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
