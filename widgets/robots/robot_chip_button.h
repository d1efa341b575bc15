#pragma once

#include <QAbstractButton>

#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/robots/robot_bar_sizes.h"

namespace leitstand {

class ReleaseHandle;

/// The button of one robot in the bar, in two lines: its link, letter, name and figures above, what it does
/// below. While a stop holds it, the lower line is the handle that releases it. Where the button is narrow,
/// words give way before figures, down to the letter; its size never depends on what it shows.
class RobotChipButton final : public QAbstractButton {
    Q_OBJECT
public:
    /// @p key: written into its tooltip; empty: none.
    explicit RobotChipButton(const QString& key, QWidget* parent = nullptr);

    void show(const RobotChip& chip, const StopLine& stop = {});
    using QWidget::show;
    [[nodiscard]] const RobotChip& chip() const { return m_chip; }
    [[nodiscard]] ReleaseHandle& handle() const { return *m_handle; }

    /// In @p font: the width that has room for the letter and for how far a stop is, in the window's
    /// language.
    [[nodiscard]] static int foldedWidth(const QFont& font);
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return {foldedWidth(font()), robot_bar::Height}; }

signals:
    void releaseRequested(const QString& robot);  ///< its name; the handle was held for a second

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
