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

/// Settings of PadInput.
struct PadInputSettings {
    PadMemory memory{{}};  ///< stores what the operator bound
    /// Called at once, on the pads' thread, when STOP on a pad is pressed, even while the window is busy.
    std::function<void()> onStop = {};
};

/// The operator's gamepads. One of them drives: the first that was plugged in, or the selected one. STOP
/// works on all of them. Pads may be plugged in and out at any time.
class PadInput final : public QObject {
    Q_OBJECT
public:
    explicit PadInput(PadInputSettings settings, QObject* parent = nullptr);
    ~PadInput() override;

    /// Returns all pads that are plugged in, in the order in which they were.
    [[nodiscard]] std::vector<PadInfo> pads() const;
    /// Returns the pad that drives. Its id is -1 when there is none.
    [[nodiscard]] PadInfo chosen() const;
    void choose(int id);
    /// Returns the bindings of the selected pad: those of the operator, overridden by those of the present
    /// layout.
    [[nodiscard]] PadBindings bindings() const;
    [[nodiscard]] PadBindings ownBindings() const { return m_own; }  ///< without those of the layout
    [[nodiscard]] PadState state() const;                            ///< state of the selected pad
    /// Binds the controls of the selected pad from now on, and stores @p bindings for pads of its model.
    void setBindings(const PadBindings& bindings);
    /// Sets the commands of the present layout, by button. They override the operator's (withCommands()).
    void setLayoutCommands(std::map<std::string, std::string> byButton);

    void setLimits(const DriveLimits& limits);
    /// Sets what pads may do now: nothing while another window has the focus, no motion while a stop is in
    /// force.
    void setScope(PadScope scope);
    void needNeutral();  ///< requires trigger and sticks to be released before anything drives
    /// Rumbles the selected pad for @p milliseconds, with @p strength from 0 to 1.
    void rumble(double strength, int milliseconds);

signals:
    /// The velocity that the sticks request. @p driving: the trigger is held and accepted. @p withoutEyes:
    /// the override of the speed limit is held. Emitted at every change, at 20 Hz while driving, and once
    /// after that.
    void sticks(const leitstand::DriveVelocity& velocity, bool driving, bool withoutEyes);
    /// @p needs: the trigger is held without effect, because trigger or sticks must be released first. False:
    /// no longer.
    void needsNeutral(bool needs);
    void joints(
        double share);  ///< as panTilt(), of the stick that tilts cameras; only while the trigger is held
    void panTilt(const leitstand::PanTiltRate& rate);  ///< sent at 20 Hz while it is not zero, then one zero
    void stopPressed();
    void commandWanted(const QString& id);
    void connected(const QString& name);
    void gone(const QString& name);
    void padsChanged();  ///< pads were plugged in or out, another is selected, or bindings changed
    void moved();        ///< the state of the selected pad changed
    void notified(const QString& text);

private:
    struct Pad {
        PadInfo info;
        PadState state;
    };
    // On the pads' thread:
    void came(const PadInfo& info);
    void receive(int id, const PadState& state);
    void went(int id);
    // On the GUI thread:
    void add(const PadInfo& info, const PadBindings& bindings);
    void take(int id, const PadState& state);
    void remove(int id);
    void update();
    void publish(const PadRequests& requests);
    [[nodiscard]] const Pad* chosenPad() const;
    void useOwn(const PadBindings& bindings);
    void watchStop(int id, const PadBindings& bindings);
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    const PadInputSettings m_settings;
    mutable std::mutex m_mutex;
    std::map<int, PadMapping> m_stops;  ///< watch for STOP, by pad id; guarded by m_mutex
    std::vector<Pad> m_pads;
    int m_chosen = -1;
    PadBindings m_own;                            ///< bindings of the selected pad
    std::map<std::string, std::string> m_layout;  ///< commands of the layout by button
    PadMapping m_mapping;                         ///< mapping of the selected pad
    PadRequests m_last;
    PadScope m_scope = PadScope::Nothing;
    std::unique_ptr<SdlPads> m_sdl;  ///< the last member, so that its thread ends first
};

}  // namespace leitstand
