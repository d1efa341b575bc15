#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/joints/joint_lines.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// A robot from its right side, with its flippers and arm as they stand now. What the controls move is drawn
/// in the colour of what is selected.
class JointDrawing final : public QWidget {
    Q_OBJECT
public:
    explicit JointDrawing(QWidget* parent = nullptr);

    /// @p reach: what the drawing has to have room for.
    void show(const SideView& body, const SideView& reach, const std::vector<JointLine>& lines);
    using QWidget::show;
    /// Sets the line below the drawing; empty: none.
    void setStatus(const QString& text, Tone tone);

    [[nodiscard]] QSize sizeHint() const override { return {220, 130}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {110, 60}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    SideView m_body, m_reach;
    std::vector<JointLine> m_lines;
    QString m_status;
    Tone m_tone = Tone::Normal;
};

}  // namespace leitstand
