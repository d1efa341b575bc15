#include "widgets/victims/evidence_strip.h"

#include <algorithm>
#include <utility>

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/painting/pane_paint.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr double EvidenceGap = 6.0, EvidenceRim = 8.0;  ///< between pictures; left and right of all [px]

}  // namespace

EvidenceStrip::EvidenceStrip(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("evidence"));
    setAccessibleName(tr("Pictures of the find"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
}

void EvidenceStrip::show(std::vector<EvidenceImage> images, bool awaited) {
    m_images = std::move(images);
    m_awaited = awaited;
    QStringList captions;
    for (const EvidenceImage& one : m_images) captions += one.caption;
    setAccessibleDescription(captions.join(QStringLiteral("; ")));
    update();
}

std::vector<QRectF> EvidenceStrip::places() const {
    double ratios = 0.0;  // widths of pictures of height 1
    for (const EvidenceImage& one : m_images) ratios += 1.0 * one.image.width() / one.image.height();
    std::vector<QRectF> places;
    if (m_images.empty()) return places;
    const double room = width() - 2.0 * EvidenceRim - EvidenceGap * static_cast<double>(m_images.size() - 1);
    const double high = std::min<double>(height(), room / ratios);
    double left = EvidenceRim;
    for (const EvidenceImage& one : m_images) {
        const double wide = high * one.image.width() / one.image.height();
        places.emplace_back(left, 0.5 * (height() - high), wide, high);
        left += wide + EvidenceGap;
    }
    return places;
}

void EvidenceStrip::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const ThemeColours& colours = coloursOf(presentTheme());
    const auto at = places();
    for (std::size_t i = 0; i < at.size(); ++i) painter.drawImage(at[i], m_images[i].image);
    if (!at.empty()) return;
    painter.setPen(colours.muted);
    painter.setFont(sized(font(), 12));
    painter.drawText(QRectF(rect()).adjusted(EvidenceRim, 0, -EvidenceRim, 0),
                     Qt::AlignVCenter | Qt::TextWordWrap,
                     m_awaited ? tr("reads the pictures…") : tr("no pictures"));
}

bool EvidenceStrip::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    const auto at = places();
    const auto under =
        std::find_if(at.begin(), at.end(), [&](const QRectF& one) { return one.contains(help->pos()); });
    if (under == at.end()) {
        QToolTip::hideText();
    } else {
        QToolTip::showText(help->globalPos(), m_images[static_cast<std::size_t>(under - at.begin())].caption,
                           this);
    }
    return true;
}

}  // namespace leitstand
