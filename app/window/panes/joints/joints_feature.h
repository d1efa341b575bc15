#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/window/input/held_keys.h"
#include "app/window/panes/view_context.h"
#include "core/robot/robot_description.h"
#include "widgets/models/joints/joint_texts.h"

class QAction;

namespace leitstand {

class JointsPanel;
struct LiveMoment;

/// The selected robot's flippers and arm ("joints"): how they stand, and with live robots the commands that
/// move them. Keys J and K, or a stick of the gamepad, move one axis up and down; presets are approached on
/// request.
class JointsFeature final : public QObject {
    Q_OBJECT
public:
    explicit JointsFeature(const ViewContext& context);

    [[nodiscard]] QWidget& pane() const;
    /// The axis that keys and gamepad move; empty: the selected robot has none.
    [[nodiscard]] std::optional<JointAxisId> chosen() const;
    /// Whether the stick of the gamepad that turns cameras moves joints now instead.
    [[nodiscard]] bool takesStick() const;

public slots:
    /// Moves the chosen axis at @p share of its rate, -1 (down) to 1 (up), until another share is set.
    void move(double share);
    /// Takes the share of the gamepad's stick. It counts only after it was 0 in this mode and for this axis.
    void takeStick(double share);
    void choose(const leitstand::JointAxisId& axis);
    void chooseNext();

private:
    void addCommands();
    void addPresets();
    void goTo(std::size_t preset);
    void changeRobot();
    void renew();
    void show(const LiveMoment& moment);
    void nameCommands();
    [[nodiscard]] const JointGroup* group() const;  ///< of the chosen axis; null: none
    [[nodiscard]] JointGroupViews views(const LiveMoment& moment) const;
    [[nodiscard]] bool mayMove() const;
    [[nodiscard]] bool isMoving() const;
    [[nodiscard]] bool padMoves() const;

    /// What the panel shows.
    struct Shown {
        const RobotDescription* robot = nullptr;
        JointGroupViews groups;
        JointAxisId chosen;
        friend bool operator==(const Shown&, const Shown&) = default;
    };

    ViewContext m_context;
    JointsPanel* m_panel;
    std::optional<Shown> m_shown;
    std::optional<HeldKeys> m_keys;           ///< empty: there is no live robot
    std::map<QString, JointAxisId> m_chosen;  ///< by robot
    QString m_robot;
    double m_share = 0.0, m_stick = 0.0;  ///< what moves now; the share of the gamepad's stick
    bool m_stickFree = true;              ///< whether the stick was at rest since that was required
    QTimer m_renewal;
    QAction *m_next = nullptr, *m_pad = nullptr;
    std::vector<QAction*> m_presets;
};

}  // namespace leitstand
