#pragma once

#include <vector>

#include <QImage>
#include <QString>
#include <QWidget>

namespace leitstand {

/// A picture of a find and its caption: "kurt3d, left, 12:04:31".
struct EvidenceImage {
    QImage image;
    QString caption;
};

/// Shows the pictures of a find side by side, as large as possible. Captions are tooltips.
class EvidenceStrip final : public QWidget {
    Q_OBJECT
public:
    explicit EvidenceStrip(QWidget* parent = nullptr);

    /// @p awaited: whether pictures exist that are still being read.
    void show(std::vector<EvidenceImage> images, bool awaited = false);
    using QWidget::show;
    [[nodiscard]] int count() const { return static_cast<int>(m_images.size()); }

    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 72}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Returns where each picture is painted.
    [[nodiscard]] std::vector<QRectF> places() const;

    std::vector<EvidenceImage> m_images;
    bool m_awaited = false;
};

}  // namespace leitstand
