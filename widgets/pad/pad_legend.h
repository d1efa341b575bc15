#pragma once

#include <vector>

#include <QWidget>

#include "core/station/pad/pad_bindings.h"
#include "widgets/models/pad/pad_texts.h"

namespace leitstand {

/// An overlay with a drawing of the gamepad and what each control does; for an unknown joystick, a list. It
/// takes no keys; a click closes it.
class PadLegend final : public QWidget {
    Q_OBJECT
public:
    explicit PadLegend(QWidget* parent = nullptr);

    /// @p name: name of the pad; empty: none is connected.
    void setPad(const QString& name, const PadBindings& bindings);
    void setCommands(std::vector<PadCommandFace> commands);
    void setState(const PadState& state);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void clicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void paintStandard(QPainter& painter, const QRectF& room) const;
    void paintList(QPainter& painter, const QRectF& room) const;

    QString m_name;
    PadBindings m_bindings;
    std::vector<PadCommandFace> m_commands;
    PadState m_state;
};

}  // namespace leitstand
