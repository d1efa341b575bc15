#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/timeline/timeline_axis.h"
#include "widgets/models/timeline/timeline_words.h"

namespace leitstand {

/// A mission's time from left to right: finds and candidates, below them all other marks, each kind of a
/// shape of its own, gaps in the recording hatched, and the moment that is shown. The mouse takes it along;
/// the arrows step by one second, with Shift by ten; Home and End go to the ends.
class TimelineBar final : public QWidget {
    Q_OBJECT
public:
    explicit TimelineBar(QWidget* parent = nullptr);

    void setMission(const TimelineAxis& axis, std::vector<TimelineGlyph> glyphs);
    void setPosition(Time at);
    /// How far the mission was read through, while it is; 1: it is. @p doing: what is done in words; empty:
    /// it is read through.
    void setOpening(double fraction, const QString& doing = {});

    /// Where @p at is painted [px].
    [[nodiscard]] double pixelOf(Time at) const;
    /// The glyph that is at @p point; null: none.
    [[nodiscard]] const TimelineGlyph* glyphAt(const QPointF& point) const;
    static constexpr int Height = 80;  ///< [px]
    [[nodiscard]] QSize sizeHint() const override { return {640, Height}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, Height}; }

signals:
    void sought(leitstand::Time at);  ///< a moment was pointed at
    void stepped(double seconds);     ///< negative: back

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
