#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/timeline/timeline_axis.h"
#include "widgets/models/timeline/timeline_text.h"

namespace leitstand {

/// Shows a mission's time from left to right. Finds and candidates are at the top, all other marks below;
/// each kind has its own shape. Gaps in the recording are hatched. The mouse drags the present moment. Arrows
/// step by one second, with Shift by ten; Home and End go to the ends.
class TimelineBar final : public QWidget {
    Q_OBJECT
public:
    explicit TimelineBar(QWidget* parent = nullptr);

    void setMission(const TimelineAxis& axis, std::vector<TimelineGlyph> glyphs);
    void setPosition(Time at);
    /// Shows the progress of reading the mission; 1: finished. @p doing: text for the present work; empty:
    /// the default text.
    void setOpening(double fraction, const QString& doing = {});

    /// Returns the x coordinate of @p at in the widget [px].
    [[nodiscard]] double pixelOf(Time at) const;
    /// Returns the glyph at @p point; null: none.
    [[nodiscard]] const TimelineGlyph* glyphAt(const QPointF& point) const;
    static constexpr int Height = 80;  ///< height [px]
    [[nodiscard]] QSize sizeHint() const override { return {640, Height}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, Height}; }

signals:
    void sought(leitstand::Time at);  ///< the operator selected a moment
    void stepped(double seconds);     ///< negative: backwards

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF track() const;
    [[nodiscard]] Time timeAt(double x) const;
    void paintTicks(QPainter& painter) const;
    void paintGlyphs(QPainter& painter) const;
    void paintPosition(QPainter& painter) const;

    TimelineAxis m_axis;
    std::vector<TimelineGlyph> m_glyphs;
    Time m_position{};
    double m_opening = 0.0;
    QString m_doing;
    bool m_dragging = false;
};

}  // namespace leitstand
