#include "app/report/pdf/pdf_report.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFont>
#include <QGuiApplication>
#include <QHashFunctions>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include "app/report/evidence_html.h"
#include "app/report/gas_curve.h"
#include "app/report/map_callouts.h"
#include "app/report/pdf/pdf_identity.h"
#include "app/report/report_html.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
namespace {

constexpr double Dots = 96.0;           ///< of the page layout, per inch
constexpr int Resolution = 300;         ///< of the file, per inch
constexpr double Gap = 10.0;            ///< between text and pictures [dots]
constexpr double LeastPicture = 260.0;  ///< height of the room for a picture [dots]
constexpr double CurveHeight = 190.0;   ///< [dots]

struct PdfText {
    Q_DECLARE_TR_FUNCTIONS(PdfText)
};

QImage imageOf(const Picture& picture) {
    const bool grey = picture.pixel == Picture::Pixel::Grey8;
    if (!grey && picture.pixel != Picture::Pixel::Rgb8) return {};
    const auto* bytes = reinterpret_cast<const uchar*>(picture.bytes.data());
    return QImage(bytes, picture.width, picture.height, picture.width * (grey ? 1 : 3),
                  grey ? QImage::Format_Grayscale8 : QImage::Format_RGB888)
        .copy();
}

/// Returns the map around a find, with the way to it.
QImage wayImage(const FindPages& pages) {
    QImage image = imageOf(pages.way.picture);
    if (image.isNull() || pages.wayPixels.size() < 2) return image;
    QPolygonF way;
    for (const Eigen::Vector2d& pixel : pages.wayPixels) way << QPointF(pixel.x(), pixel.y());
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double wide = std::max(2.0, image.width() / 220.0);
    painter.setPen(QPen(Qt::white, 2.2 * wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(way);
    painter.setPen(QPen(QColor(0xD5, 0x5E, 0x00), wide, Qt::DashLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(way);
    painter.setPen(QPen(Qt::black, wide));
    painter.setBrush(QColor(0xD5, 0x5E, 0x00));
    painter.drawEllipse(way.first(), 2.5 * wide, 2.5 * wide);
    return image;
}

/// Lays out pages one after the other. Lengths are dots of 1/96 inch.
class Pages {
public:
    Pages(QPdfWriter& writer, const ReportContent& content)
        : m_writer(writer), m_painter(&writer), m_footer(QString::fromStdString(content.name)) {
        m_painter.scale(Resolution / Dots, Resolution / Dots);
        m_size = QSizeF(writer.width(), writer.height()) * (Dots / Resolution);
        m_size.setHeight(m_size.height() - 24.0);  // for the footer
        m_font = QFont(QStringLiteral("DejaVu Sans"));
        m_font.setPixelSize(12);
        // Qt makes no ligatures of spaced letters, so a search for "confirmed" finds it.
        m_font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
        begin();
    }
    [[nodiscard]] bool ok() const { return m_painter.isActive(); }

    void nextPage() {
        m_writer.newPage();
        ++m_page;
        m_below = 0.0;
        begin();
    }

    /// Begins the next page unless most of this one is free.
    void nextPageUnlessFree() {
        constexpr double Most = 0.4;  // used share of the page
        if (m_below > Most * m_size.height()) nextPage();
    }

    /// Draws a section. Begins the next page when the rest of this one does not hold it and @p below more
    /// [dots]. A section longer than a page continues on further pages.
    void text(const QString& html, const std::vector<std::pair<QString, QImage>>& pictures = {},
              double below = 0.0) {
        QTextDocument document;
        document.setDefaultFont(m_font);
        document.setDocumentMargin(0.0);
        document.setDefaultStyleSheet(QStringLiteral(
            "h1 { font-size: 20px } h2 { font-size: 15px; margin-top: 12px } small { color: #444444 }"));
        for (const auto& [name, image] : pictures)
            document.addResource(QTextDocument::ImageResource, QUrl(name), image);
        document.setHtml(html);
        document.setTextWidth(m_size.width());
        const double height = document.size().height();
        if (m_below > 0.0) {
            m_below += Gap;
            if (m_below + height + below > m_size.height()) nextPage();
        }
        if (height <= m_size.height()) return draw(document, 0.0, height);
        document.setPageSize(m_size);
        for (int page = 0; page < document.pageCount(); ++page) {
            if (page > 0) nextPage();
            const double top = page * m_size.height();
            draw(document, top, std::min(m_size.height(), document.size().height() - top));
        }
    }

    /// Calls @p paint with a room as wide as the page and @p high [dots], on the next page when it does not
    /// fit.
    void drawing(double high, const std::function<void(QPainter&, const QRectF&)>& paint) {
        if (m_below > 0.0 && m_below + Gap + high > m_size.height()) nextPage();
        m_painter.setFont(m_font);
        paint(m_painter, QRectF(0.0, m_below + Gap, m_size.width(), high));
        m_below += Gap + high;
    }

    /// Draws @p image as large as fits, leaves @p below [dots] free under it and adds @p caption. Before the
    /// caption, @p over draws into the place of the image and below it. Begins the next page when there is
    /// little room.
    void picture(const QImage& image, const QString& caption, double below = 0.0,
                 const std::function<void(QPainter&, const QRectF&)>& over = {}) {
        if (image.isNull()) return;
        if (m_below > 0.0 && m_size.height() - m_below < LeastPicture) nextPage();
        const double line = caption.isEmpty() ? 0.0 : 18.0;
        const QSizeF room(m_size.width(), m_size.height() - m_below - Gap - below - line);
        const QSizeF size = QSizeF(image.size()).scaled(room, Qt::KeepAspectRatio);
        const QPointF corner((m_size.width() - size.width()) / 2, m_below + Gap);
        m_painter.setRenderHint(QPainter::LosslessImageRendering);
        m_painter.drawImage(QRectF(corner, size), image);
        m_painter.setRenderHint(QPainter::LosslessImageRendering, false);
        m_painter.setFont(m_font);
        if (over) over(m_painter, QRectF(corner, size));
        m_below = corner.y() + size.height() + below;
        m_painter.drawText(QRectF(0.0, m_below, m_size.width(), line), Qt::AlignHCenter | Qt::AlignVCenter,
                           caption);
        m_below += line;
    }

private:
    void begin() {
        QFont font = m_font;
        font.setPixelSize(10);
        m_painter.setFont(font);
        m_painter.setPen(Qt::darkGray);
        const QRectF foot(0.0, m_size.height() + 8.0, m_size.width(), 16.0);
        m_painter.drawText(foot, Qt::AlignLeft, m_footer);
        m_painter.drawText(foot, Qt::AlignRight, PdfText::tr("page %1").arg(m_page));
        m_painter.setPen(Qt::black);
    }
    void draw(QTextDocument& document, double top, double height) {
        m_painter.save();
        m_painter.translate(0.0, m_below - top);
        const QRectF part(0.0, top, m_size.width(), height);
        m_painter.setClipRect(part);
        // Text is black on paper even when the window is dark.
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = part;
        context.palette.setColor(QPalette::Text, Qt::black);
        document.documentLayout()->draw(&m_painter, context);
        m_painter.restore();
        m_below += height;
    }

    QPdfWriter& m_writer;
    QPainter m_painter;
    QString m_footer;
    QSizeF m_size;
    QFont m_font;
    double m_below = 0.0;  ///< lower end of what is on the page [dots]
    int m_page = 1;
};

void layOut(Pages& pages, const ReportContent& content) {
    for (const QString& section : overviewHtml(content)) pages.text(section);
    for (const PrintedMap& printed : content.maps) {
        &printed == &content.maps.front() ? pages.nextPageUnlessFree() : pages.nextPage();
        pages.text(
            QStringLiteral("<p><b>%1</b></p>").arg(mapCaption(content, printed.shows).toHtmlEscaped()));
        const MapPicture& map = printed.picture;
        const auto over = [&](QPainter& painter, const QRectF& picture) {
            drawCallouts(painter, picture, map, marksOf(content.model, printed.shows.storey));
            const double dots = picture.width() / map.picture.width / map.perPixel;
            drawScale(painter, picture.bottomLeft(), dots);
        };
        pages.picture(imageOf(map.picture),
                      PdfText::tr("x is up, y is left; lines of the grid are 0.5 m apart"), ScaleHeight,
                      over);
    }
    for (std::size_t find = 0; find < content.finds.size(); ++find) {
        pages.nextPage();
        std::vector<std::pair<QString, QImage>> pictures;
        for (const PrintedPicture& printed : printedPictures(content.finds[find]))
            pictures.emplace_back(evidenceName(find, pictures.size()), imageOf(*printed.picture));
        pages.text(findHtml(content, find), pictures);
        for (const GasTrace& trace : content.finds[find].gas) {
            if (!isCurve(trace)) continue;
            pages.drawing(CurveHeight,
                          [&](QPainter& painter, const QRectF& room) { drawGasCurve(painter, room, trace); });
        }
        const QImage way = wayImage(content.finds[find]);
        pages.text(wayHtml(content.model.finds[find]), {}, way.isNull() ? 0.0 : LeastPicture);
        pages.picture(way, PdfText::tr("x is up, y is left; lines of the grid are 0.5 m apart"));
    }
}

}  // namespace

Result<std::string> pdfOf(const ReportContent& content) {
    if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr)
        return Error{"the PDF cannot be laid out: fonts need a QGuiApplication"};
    // Qt writes fonts in hash order. A fixed seed makes equal bytes of equal contents.
    const struct SteadyHashes {
        SteadyHashes() { QHashSeed::setDeterministicGlobalSeed(); }
        ~SteadyHashes() { QHashSeed::resetRandomGlobalSeed(); }
    } steady;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(Resolution);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(16, 14, 16, 12), QPageLayout::Millimeter);
        writer.setTitle(QString::fromStdString(content.name));
        writer.setCreator(QString::fromStdString("Leitstand " + content.version));
        Pages pages(writer, content);
        if (!pages.ok()) return Error{"the PDF cannot be laid out: no page could be begun"};
        layOut(pages, content);
    }
    return withIdentity(buffer.data(), content.created).toStdString();
}

}  // namespace leitstand
