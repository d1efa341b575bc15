#include "widgets/painting/theme.h"

#include <QApplication>
#include <QFile>
#include <QFont>
#include <QFontInfo>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

static void registerResources() {
    // Resources in a static library must be registered by hand, outside any namespace.
    Q_INIT_RESOURCE(leitstand);
}

namespace leitstand {
namespace {

constexpr int BodySize = 13;  ///< [px]

QPalette paletteFrom(const ThemeColours& colours) {
    QPalette palette;
    palette.setColor(QPalette::Window, colours.window);
    palette.setColor(QPalette::Base, colours.pane);
    palette.setColor(QPalette::AlternateBase, colours.strip);
    palette.setColor(QPalette::Button, colours.field);
    palette.setColor(QPalette::ToolTipBase, colours.strip);
    palette.setColor(QPalette::Mid, colours.line);
    palette.setColor(QPalette::Highlight, colours.select);
    palette.setColor(QPalette::HighlightedText, colours.window);
    palette.setColor(QPalette::Link, colours.select);
    palette.setColor(QPalette::BrightText, colours.attention);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, colours.text);
        palette.setColor(QPalette::Disabled, role, colours.muted);
    }
    palette.setColor(QPalette::PlaceholderText, colours.muted);
    return palette;
}

QString styleSheetFrom(const ThemeColours& colours, Theme theme) {
    QFile file(QStringLiteral(":/leitstand/theme.qss"));
    if (!file.open(QIODevice::ReadOnly)) qFatal("the theme is not in the program's resources");
    QString sheet = QString::fromUtf8(file.readAll());
    const std::pair<const char*, QColor> fills[] = {
        {"@window", colours.window}, {"@pane", colours.pane},     {"@strip", colours.strip},
        {"@field", colours.field},   {"@hover", colours.hover},   {"@chosen", colours.chosen},
        {"@line", colours.line},     {"@faint", colours.faint},   {"@text", colours.text},
        {"@muted", colours.muted},   {"@select", colours.select}, {"@attention", colours.attention},
        {"@act", colours.act},       {"@fine", colours.fine},
    };
    for (const auto& [name, colour] : fills) sheet.replace(QLatin1String(name), colour.name());
    return sheet.replace(QLatin1String("@check"), QLatin1String(theme == Theme::Dark ? "dark" : "light"));
}

QFont bodyFont() {
    QFont font;
    font.setFamilies({QStringLiteral("Inter"), QStringLiteral("DejaVu Sans"), QStringLiteral("Noto Sans")});
    font.setPixelSize(BodySize);
    return font;
}

}  // namespace

const ThemeColours& coloursOf(Theme theme) {
    static const ThemeColours dark = {
        .window = "#12151A",
        .pane = "#161A20",
        .strip = "#1B1F26",
        .field = "#1F252D",
        .hover = "#28303A",
        .chosen = "#1C3242",
        .line = "#2E3440",
        .faint = "#20252D",
        .text = "#E6E9EF",
        .muted = "#9AA3B2",
        .select = "#56B4E9",
        .fine = "#009E73",
        .attention = "#E69F00",
        .act = "#D55E00",
        .stop = "#C8371B",
        .wall = "#E8C410",
        .obstacle = "#FFFFFF",
        .laser = "#F06FC0",
        .teleoperation = "#123240",
        .autonomous = "#35264F",
        .stopped = "#2B313A",
        .lost = "#3A2D0E",
        .robots = {"#56B4E9", "#C49BEB", "#86CFC4", "#D3B59C", "#A5D46A", "#7F93FF", "#F4A09C", "#E9E2B0"},
    };
    static const ThemeColours light = {
        .window = "#F3F4F6",
        .pane = "#FFFFFF",
        .strip = "#E9ECF0",
        .field = "#FFFFFF",
        .hover = "#DDE3EA",
        .chosen = "#D3E7F5",
        .line = "#BFC6D1",
        .faint = "#E6E9EE",
        .text = "#12151A",
        .muted = "#535D6E",
        .select = "#0072B2",
        .fine = "#00694D",
        .attention = "#8F5400",
        .act = "#B04A00",
        .stop = "#C8371B",
        .wall = "#8A7000",
        .obstacle = "#12151A",
        .laser = "#B0217F",
        .teleoperation = "#CBE4F4",
        .autonomous = "#E1D5F5",
        .stopped = "#DDE1E7",
        .lost = "#F6E5C0",
        .robots = {"#0072B2", "#7A3FB0", "#1B766B", "#7A5638", "#557C0A", "#3A3FD0", "#A03A5A", "#454B54"},
    };
    return theme == Theme::Dark ? dark : light;
}

Theme presentTheme() {
    const QColor window = QGuiApplication::palette().color(QPalette::Window);
    return window.lightness() < 128 ? Theme::Dark : Theme::Light;
}

void applyTheme(QApplication& application, Theme theme) {
    registerResources();
    const ThemeColours& colours = coloursOf(theme);
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setFont(bodyFont());
    application.setPalette(paletteFrom(colours));
    application.setStyleSheet(styleSheetFrom(colours, theme));
}

}  // namespace leitstand
