#pragma once

#include <map>
#include <string>
#include <vector>

#include <QStringList>
#include <QWidget>

#include "widgets/models/live/preflight_list.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableView;
class QTimer;

namespace leitstand {

/// What is in order before a mission and what is not, robot by robot; brake tests; adding robots. Says what
/// the operator wants by its signals.
class PreflightPage final : public QWidget {
    Q_OBJECT
public:
    explicit PreflightPage(QWidget* parent = nullptr);

    /// @p faces: of all robots, in their order; @p strangers: robots that may be added.
    void show(std::vector<PreflightCheck> checks, const std::vector<RobotFace>& faces,
              const QStringList& strangers);
    using QWidget::show;
    /// How the brake test of the chosen robot stands; @p refused: it may only be driven nevertheless.
    void showBrake(const QString& text, bool refused, bool overridden);
    void complain(const QString& text);        ///< why a robot cannot be added
    [[nodiscard]] QString brakeRobot() const;  ///< chosen; its name
    [[nodiscard]] const PreflightList& list() const { return m_list; }

signals:
    void checkAgainWanted();
    void tonesWanted();  ///< to be heard, both of them
    void brakeBegun(const QString& robot);
    void brakeHeld(const QString& robot);  ///< twenty times a second while the button is down
    void brakeEnded(const QString& robot);
    void overrideWanted(const QString& robot, bool on);
    void strangerWanted(const QString& robot);
    void fileWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* head();
    QWidget* brakes();
    QWidget* robots();
    void press();
    void letGo();

    PreflightList m_list;
    QTableView* m_table;
    QLabel *m_verdict, *m_brakeText, *m_complaint;
    QComboBox *m_robot, *m_stranger;
    QPushButton *m_test, *m_add;
    QCheckBox* m_override;
    QTimer* m_rhythm;
    QString m_tested;  ///< robot whose test runs
};

}  // namespace leitstand
