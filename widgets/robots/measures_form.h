#pragma once

#include <array>
#include <vector>

#include <QString>
#include <QWidget>

#include "widgets/models/live/robots/measures.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace leitstand {

class MeasuresDrawing;
class NumberBox;

/// Shows and takes how large a robot is and where its sensors sit, with a drawing to scale.
class MeasuresForm final : public QWidget {
    Q_OBJECT
public:
    explicit MeasuresForm(QWidget* parent = nullptr);

    void setMeasures(const Measures& measures);
    [[nodiscard]] const Measures& measures() const { return m_measures; }
    /// Sets whether the robot's model is known, from which measures can be taken.
    void setModelKnown(bool known);
    /// Sets why nothing can be saved now; empty: it can.
    void setRefusal(const QString& why);
    void complain(const QString& problem);  ///< empty: nothing is wrong

signals:
    void modelWanted();  ///< the measures of the robot's model shall be shown
    void saveWanted();   ///< measures() shall be written, and used
    void closeWanted();

private:
    QWidget* body();
    QWidget* sensors();
    QWidget* buttons();
    void showNumbers();
    void fillSensors();
    void takeSides();
    void takeSensors();
    void showDrawing();

    /// The boxes of one sensor: x, y, z [m], roll, pitch, yaw [degrees].
    using SensorBoxes = std::array<NumberBox*, 6>;

    Measures m_measures;
    std::string m_chosen;  ///< name of the sensor whose numbers are being changed
    bool m_filling = false;
    MeasuresDrawing* m_drawing;
    std::array<NumberBox*, 4> m_sides{};  ///< front, rear, left, right
    NumberBox* m_height = nullptr;
    QLabel* m_outline = nullptr;
    QWidget* m_table = nullptr;
    QGridLayout* m_grid = nullptr;
    std::vector<SensorBoxes> m_boxes;
    QPushButton *m_model = nullptr, *m_save = nullptr;
    QLabel* m_problem = nullptr;
};

}  // namespace leitstand
