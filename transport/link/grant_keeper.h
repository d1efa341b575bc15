#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/robot/control/grant_book.h"
#include "transport/dds/node.h"

namespace leitstand {

/// How grants travel: reliable, transient local, as all topics below /leitstand/.
[[nodiscard]] Qos grantQos();

/// Called on the keeper's own thread, without any lock held; may call the keeper, but not destroy it.
struct GrantListener {
    std::function<void()> onChange = {};                      ///< what view() or mayAct() say has changed
    std::function<void(std::vector<HeldGrant>)> onHeld = {};  ///< what is held changed: to be remembered
};

/// A station's grants over DDS (GrantBook): heartbeats, requests and answers on /leitstand/grants. Drive
/// commands and releases have to come from the same node, or robots will not take them for the holder's.
/// Any thread; nothing waits for the network.
class GrantKeeper {
public:
    /// What @p me held before it ended is held again at once. An error when the node may not speak of grants
    /// (a viewer in a secured domain).
    [[nodiscard]] static Result<std::unique_ptr<GrantKeeper>> create(Node& node, const StationIdentity& me,
                                                                     GrantListener listener = {},
                                                                     const GrantTiming& timing = {});
    /// Gives everything up, without calling the listener: what was held is still to be remembered.
    ~GrantKeeper();
    GrantKeeper(const GrantKeeper&) = delete;
    GrantKeeper& operator=(const GrantKeeper&) = delete;

    /// As of GrantBook; before anything is heard of this process under its new identity.
    void rejoined(const Guid& participant);
    void ask(const GrantId& id);
    void release(const GrantId& id);  ///< asks no more, too
    void answer(const GrantId& id, bool consent);

    [[nodiscard]] GrantView view(const GrantId& id) const;
    [[nodiscard]] bool mayAct(const GrantId& id) const;
    [[nodiscard]] std::vector<HeldGrant> held() const;

private:
    struct State;
    explicit GrantKeeper(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
