#pragma once

#include <map>
#include <string>
#include <vector>

#include <QStringList>
#include <QWidget>

#include "widgets/models/live/preflight/preflight_list.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableView;
class QTimer;

namespace leitstand {

/// Shows the checks before a mission, grouped by robot. Below them are the brake test and the robots that can
/// be added. Emits the operator's requests.
class PreflightPage final : public QWidget {
    Q_OBJECT
public:
    explicit PreflightPage(QWidget* parent = nullptr);

    /// @p faces: faces of all robots, in their order. @p strangers: names of robots that can be added.
    void show(std::vector<PreflightCheck> checks, const std::vector<RobotFace>& faces,
              const QStringList& strangers);
    using QWidget::show;
    /// Shows the state of the selected robot's brake test. @p refused: whether the test failed, so that
    /// driving needs the override. @p overridden: whether the override is on.
    void showBrake(const QString& text, bool refused, bool overridden);
    void complain(const QString& text);        ///< shows why a robot cannot be added
    [[nodiscard]] QString brakeRobot() const;  ///< name of the robot selected for the brake test
    [[nodiscard]] const PreflightList& list() const { return m_list; }

signals:
    void checkAgainWanted();
    void tonesWanted();  ///< the operator wants to hear both alarm tones
    void brakeBegun(const QString& robot);
    void brakeHeld(const QString& robot);  ///< emitted at 20 Hz while the button is held
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
    QString m_tested;  ///< robot whose test is running
};

}  // namespace leitstand
