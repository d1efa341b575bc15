#pragma once

#include <QAbstractButton>

#include "widgets/models/live/robot_chip.h"

namespace leitstand {

/// One robot of the bar. It leaves out words before figures when it gets narrow.
class RobotChipButton final : public QAbstractButton {
    Q_OBJECT
public:
    /// @p key: written into its tooltip; empty: none.
    explicit RobotChipButton(const QString& key, QWidget* parent = nullptr);

    void show(const RobotChip& chip);
    using QWidget::show;
    [[nodiscard]] const RobotChip& chip() const { return m_chip; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] int widthFor(const QString& text) const;

    RobotChip m_chip;
    QString m_key;
};

}  // namespace leitstand
