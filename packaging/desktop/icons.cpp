// Draws an SVG in the sizes that icon themes ask for: leitstand-icons ICON.svg .../48x48/apps/NAME.png ...
#include <cstdio>

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

int main(int argc, char** argv) {
    QSvgRenderer svg(QString::fromLocal8Bit(argc > 1 ? argv[1] : ""));
    if (!svg.isValid()) {
        std::fputs("leitstand-icons: expected an SVG and files in folders such as 48x48/apps\n", stderr);
        return 1;
    }
    for (int i = 2; i < argc; ++i) {
        const QFileInfo file(QString::fromLocal8Bit(argv[i]));
        QDir().mkpath(file.path());
        const int size = QDir::cleanPath(file.path() + "/..").section('/', -1).section('x', 0, 0).toInt();
        QImage picture(size, size, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        svg.render(&painter);
        painter.end();
        if (!picture.save(file.filePath())) {
            std::fprintf(stderr, "leitstand-icons: %s: cannot be written\n", argv[i]);
            return 1;
        }
    }
    return 0;
}
