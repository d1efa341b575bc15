#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "app/services/pad/pad_memory.h"
#include "app/window/live/pad/sdl_pads.h"
#include "core/station/pad/pad_mapping.h"

namespace leitstand {

/// How gamepads are used.
struct PadInputSettings {
    PadMemory memory{{}};  ///< of what the operator bound
    /// Called at once on the pads' thread when a pad's STOP is pressed, also while the window is busy.
    std::function<void()> onStop = {};
};

/// The operator's gamepads: one of them drives, the first that came or the one that was chosen; STOP works on
/// all. Pads come and go as they like.
class PadInput final : public QObject {
    Q_OBJECT
public:
    explicit PadInput(PadInputSettings settings, QObject* parent = nullptr);
    ~PadInput() override;

    /// All that are plugged in, as they came.
    [[nodiscard]] std::vector<PadInfo> pads() const;
    /// The one that drives; its id is -1 when there is none.
    [[nodiscard]] PadInfo chosen() const;
    void choose(int id);
    /// What the chosen one does: as the operator bound it, and the layout in use.
    [[nodiscard]] PadBindings bindings() const;
    [[nodiscard]] PadBindings ownBindings() const { return m_own; }  ///< without the layout
    [[nodiscard]] PadState state() const;                            ///< of the chosen one
    /// What the chosen pad does from now on, and the next time.
    void setBindings(const PadBindings& bindings);
    /// Commands that go before the operator's, by button (withCommands).
    void setLayoutCommands(std::map<std::string, std::string> byButton);

    void setLimits(const DriveLimits& limits);
    /// What pads may do now: nothing while another window has the focus, no motion while a stop stands.
    void setScope(PadScope scope);
    void needNeutral();  ///< trigger and sticks have to be let go first
    /// Lets the chosen pad tremble, @p strength 0 to 1.
    void rumble(double strength, int milliseconds);

signals:
    /// The sticks; @p driving: the trigger is held and counts; @p withoutEyes: with the override of the speed
    /// cap. With every change, and 20 times a second.
    void sticks(const leitstand::DriveVelocity& velocity, bool driving, bool withoutEyes);
    /// The trigger is held in vain: trigger or sticks have to be let go first.
    void needsNeutral(bool needs);
    void panTilt(const leitstand::PanTiltRate& rate);  ///< 20 times a second while it is not zero, and a zero
    void stopPressed();
    void commandWanted(const QString& id);
    void connected(const QString& name);
    void gone(const QString& name);
    void padsChanged();  ///< other pads, another one chosen, or it does other things
    void moved();        ///< the chosen one's state changed
    void notified(const QString& text);

private:
    struct Pad {
        PadInfo info;
        PadState state;
    };
    // On the pads' thread:
    void came(const PadInfo& info);
    void says(int id, const PadState& state);
    void went(int id);
    // On the GUI thread:
    void add(const PadInfo& info, const PadBindings& bindings);
    void take(int id, const PadState& state);
    void remove(int id);
    void update();
    void tell(const PadWishes& wishes);
    [[nodiscard]] const Pad* chosenPad() const;
    void useOwn(const PadBindings& bindings);
    void watchStop(int id, const PadBindings& bindings);
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    const PadInputSettings m_settings;
    mutable std::mutex m_mutex;
    std::map<int, PadMapping> m_stops;  ///< under the mutex: who stops; as the operator bound them
    std::vector<Pad> m_pads;
    int m_chosen = -1;
    PadBindings m_own;                            ///< of the chosen one
    std::map<std::string, std::string> m_layout;  ///< commands by button
    PadMapping m_mapping;                         ///< of the chosen one
    PadWishes m_last;
    PadScope m_scope = PadScope::Nothing;
    std::unique_ptr<SdlPads> m_sdl;  ///< last: its thread ends first
};

}  // namespace leitstand
