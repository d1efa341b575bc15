#include "widgets/map_view/overlays/legend.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <QCoreApplication>
#include <QFontMetrics>
#include <QLinearGradient>
#include <QPainter>

#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/scene/scene_content.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr int Margin = 12, Square = 10, Gap = 6;  // [px]
constexpr std::size_t MostScans = 8;

/// Distances within the legend [px].
struct Spacing {
    int padding, space, ramp;
};
constexpr Spacing Roomy{9, 14, 120}, Tight{6, 8, 60};

/// A coloured square and its meaning.
struct Entry {
    Rgba colour;
    QString text;
};

/// The title and the ends of a colour ramp as text.
struct RampText {
    QString title, low, high;
};

QString labelText(Label label) {
    switch (label) {
        case Label::Floor:
            return QCoreApplication::translate("leitstand::MapView", "floor");
        case Label::Wall:
            return QCoreApplication::translate("leitstand::MapView", "wall");
        case Label::Ceiling:
            return QCoreApplication::translate("leitstand::MapView", "ceiling");
        case Label::Unlabelled:
            break;
    }
    return QCoreApplication::translate("leitstand::MapView", "unlabelled");
}

bool isPresent(Label label, const SceneContent& content) {
    for (const SceneScan& scan : content.scans) {
        const auto index = static_cast<std::size_t>(label);
        if (scan.visible && scan.points && scan.points->labelCounts[index] > 0) return true;
    }
    return false;
}

/// Returns the labels that are drawn in a colour of their own.
std::vector<Entry> labelEntries(const SceneContent& content) {
    const bool top = content.settings.look == MapLook::Top;
    std::vector<Entry> entries;
    for (const Label label : {Label::Floor, Label::Wall, Label::Ceiling, Label::Unlabelled}) {
        if ((!content.withCeiling() && label == Label::Ceiling) || !isPresent(label, content)) continue;
        const bool ground = top && label == Label::Floor;
        if (!ground && content.settings.colouring != MapColouring::Label) continue;
        entries.push_back(
            {ground ? mapColours(content.settings.theme).ground : labelColour(label), labelText(label)});
    }
    return entries;
}

bool doubted(const SceneContent& content) {
    return std::any_of(content.scans.begin(), content.scans.end(),
                       [](const SceneScan& scan) { return scan.visible && scan.uncertain; });
}

/// Returns the scan's name, or else what the list of key scans shows: "K 12".
QString nameOf(const SceneScan& scan, const SceneContent& content) {
    if (!scan.name.empty()) return othersText(scan.name);
    QString robot;
    if (scan.robotAt < content.robots.size()) {
        const SceneRobot& by = content.robots[scan.robotAt];
        robot = othersText(by.letter.empty() ? by.title : by.letter);
    }
    return QStringLiteral("%1 %2").arg(robot.isEmpty() ? QStringLiteral("?") : robot).arg(scan.id);
}

/// Adds the first scans of a map from files, or the newest scans of a live map.
void addScans(std::vector<Entry>& entries, const SceneContent& content) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < content.scans.size(); ++i) {
        if (content.scans[i].visible && !content.scans[i].uncertain) order.push_back(i);
    }
    const bool live = !order.empty() && content.scans[order.back()].entered != Time{};
    if (live) std::reverse(order.begin(), order.end());
    const std::size_t named = std::min(order.size(), MostScans - std::min(entries.size(), MostScans));
    for (std::size_t i = 0; i < named; ++i) {
        const SceneScan& scan = content.scans[order[i]];
        entries.push_back({scanColour(order[i]), nameOf(scan, content)});
    }
    if (order.size() > named)
        entries.push_back({Rgba{0, 0, 0, 0}, QStringLiteral("+%1").arg(order.size() - named)});
}

std::vector<Entry> entriesFor(const SceneContent& content) {
    std::vector<Entry> entries = labelEntries(content);
    if (doubted(content)) {
        const MapColours& colours = mapColours(content.settings.theme);
        entries.push_back({content.inQuestion != 0 ? colours.scanInQuestion : colours.uncertainScan,
                           QCoreApplication::translate("leitstand::MapView", "uncertain ?")});
    }
    if (content.changes) {
        const MapColours& colours = mapColours(content.settings.theme);
        entries.push_back({colours.newThing,
                           QCoreApplication::translate("leitstand::MapView", "new", "what came to a place")});
        entries.push_back({colours.goneThing,
                           QCoreApplication::translate("leitstand::MapView", "gone", "what was taken away")});
    }
    if (content.moves)
        entries.push_back({mapColours(content.settings.theme).scanInQuestion,
                           content.dragged
                               ? QCoreApplication::translate("leitstand::MapView", "moved by hand")
                               : QCoreApplication::translate("leitstand::MapView", "if it is one place",
                                                             "where scans would come to stand")});
    if (content.settings.colouring == MapColouring::Robot) {
        for (std::size_t i = 0; i < content.robots.size(); ++i) {
            const SceneRobot& robot = content.robots[i];
            const bool took = std::any_of(content.scans.begin(), content.scans.end(),
                                          [&](const SceneScan& scan) { return scan.robotAt == i; });
            const QString title = othersText(robot.title);
            if (took)
                entries.push_back({robotColour(robot.place, content.settings.theme),
                                   title.isEmpty()
                                       ? QCoreApplication::translate("leitstand::MapView", "no robot named")
                                       : title});
        }
    }
    if (content.settings.colouring == MapColouring::Intensity && !content.ramp && !content.scans.empty())
        entries.push_back({labelColour(Label::Unlabelled),
                           QCoreApplication::translate("leitstand::MapView", "no intensities in the data")});
    if (content.settings.colouring == MapColouring::Scan) addScans(entries, content);
    return entries;
}

std::optional<RampText> rampText(const SceneContent& content, const OverlayStyle& style) {
    if (!content.ramp) return std::nullopt;
    if (content.settings.colouring == MapColouring::Intensity)
        return RampText{QCoreApplication::translate("leitstand::MapView", "intensity"),
                        QCoreApplication::translate("leitstand::MapView", "low"),
                        QCoreApplication::translate("leitstand::MapView", "high")};
    if (content.settings.colouring == MapColouring::Age) {
        if (content.ages == SceneAges::Scans)
            return RampText{QCoreApplication::translate("leitstand::MapView", "order"),
                            QCoreApplication::translate("leitstand::MapView", "first"),
                            QCoreApplication::translate("leitstand::MapView", "last")};
        return RampText{QCoreApplication::translate("leitstand::MapView", "age"),
                        QStringLiteral("%1 min").arg(numberText(content.ramp->high, 1, style.locale)),
                        QCoreApplication::translate("leitstand::MapView", "new")};
    }
    const bool height = content.settings.colouring == MapColouring::Height;
    const int decimals = height ? 1 : 0;
    return RampText{height ? QCoreApplication::translate("leitstand::MapView", "height")
                           : QCoreApplication::translate("leitstand::MapView", "range"),
                    numberText(content.ramp->low, decimals, style.locale),
                    QStringLiteral("%1 m").arg(numberText(content.ramp->high, decimals, style.locale))};
}

/// Writes from left to right on one line.
class LineWriter {
public:
    LineWriter(QPainter& painter, const QRect& box) : m_painter(painter), m_box(box), m_x(box.left()) {}

    void text(const QString& text, const QColor& colour, int gapAfter) {
        m_painter.setPen(colour);
        const int width = m_painter.fontMetrics().horizontalAdvance(text);
        m_painter.drawText(QRect(m_x, m_box.top(), width + 2, m_box.height()), Qt::AlignVCenter, text);
        m_x += width + gapAfter;
    }

    void square(const QColor& colour) {
        m_painter.fillRect(m_x, m_box.center().y() - Square / 2 + 1, Square, Square, colour);
        m_x += Square + Gap;
    }

    void ramp(int width) {
        constexpr int Steps = 16;
        QLinearGradient gradient(m_x, 0, m_x + width, 0);
        for (int i = 0; i <= Steps; ++i) {
            const double t = static_cast<double>(i) / Steps;
            gradient.setColorAt(t, asColour(viridis(t)));
        }
        m_painter.fillRect(m_x, m_box.center().y() - 3, width, 8, gradient);
        m_x += width + Gap;
    }

private:
    QPainter& m_painter;
    QRect m_box;
    int m_x;
};

int widthOf(const std::vector<Entry>& entries, const std::optional<RampText>& ramp,
            const QFontMetrics& metrics, const Spacing& spacing) {
    int width = 2 * spacing.padding;
    for (const Entry& entry : entries) {
        width += Square + Gap + metrics.horizontalAdvance(entry.text) + spacing.space;
    }
    if (!ramp) return width - spacing.space;
    return width + metrics.horizontalAdvance(ramp->title) + spacing.space +
           metrics.horizontalAdvance(ramp->low) + Gap + spacing.ramp + Gap +
           metrics.horizontalAdvance(ramp->high);
}

}  // namespace

QRect paintLegend(QPainter& painter, const SceneContent& content, QSize size, const QRect& taken,
                  const OverlayStyle& style) {
    const std::vector<Entry> entries = entriesFor(content);
    const std::optional<RampText> ramp = rampText(content, style);
    if (entries.empty() && !ramp) return {};

    painter.setFont(style.font);
    const QFontMetrics metrics = painter.fontMetrics();
    const int height = metrics.height() + 10;
    const auto fits = [&](const Spacing& spacing) {
        return Margin + widthOf(entries, ramp, metrics, spacing) + Gap <= taken.left();
    };
    const Spacing& spacing = fits(Roomy) ? Roomy : Tight;
    QRect box(Margin, size.height() - Margin - height, widthOf(entries, ramp, metrics, spacing), height);
    if (!fits(spacing)) box.moveBottom(taken.top() - Gap);
    paintPanel(painter, box, style);

    const QColor text = asColour(style.colours.text), muted = asColour(style.colours.muted);
    LineWriter line(painter, box.adjusted(spacing.padding, 0, -spacing.padding, 0));
    for (const Entry& entry : entries) {
        line.square(asColour(entry.colour));
        line.text(entry.text, text, spacing.space);
    }
    if (!ramp) return box;
    line.text(ramp->title, muted, spacing.space);
    line.text(ramp->low, text, Gap);
    line.ramp(spacing.ramp);
    line.text(ramp->high, text, 0);
    return box;
}

}  // namespace leitstand
