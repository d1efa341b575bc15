#pragma once

#include <QAbstractButton>

#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/robots/robot_bar_sizes.h"

namespace leitstand {

class ReleaseHandle;

/// The button of one robot in the bar. The upper line shows link, letter, name and figures; the lower line
/// shows the mode. While a stop holds the robot, the lower line is the release handle. A narrow button leaves
/// out words first, then figures, down to the letter. Its size does not depend on its contents.
class RobotChipButton final : public QAbstractButton {
    Q_OBJECT
public:
    /// @p key: key that selects the robot, for the tooltip; empty: none.
    explicit RobotChipButton(const QString& key, QWidget* parent = nullptr);

    void show(const RobotChip& chip, const StopLine& stop = {});
    using QWidget::show;
    [[nodiscard]] const RobotChip& chip() const { return m_chip; }
    [[nodiscard]] ReleaseHandle& handle() const { return *m_handle; }

    /// Returns the width needed for letter, battery and every state of a stop, in @p font and the window's
    /// language [px].
    [[nodiscard]] static int foldedWidth(const QFont& font);
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return {foldedWidth(font()), robot_bar::Height}; }

signals:
    void releaseRequested(const QString& robot);  ///< RobotFace::name; the handle was held for a second

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void paintIdentity(QPainter& painter, const QRectF& line) const;
    void paintMode(QPainter& painter, const QRectF& line) const;

    RobotChip m_chip;
    StopLine m_stop;
    QString m_key;
    ReleaseHandle* m_handle;
};

}  // namespace leitstand
