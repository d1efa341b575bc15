#include "widgets/painting/plain_texts.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QTextBoundaryFinder>

namespace leitstand {
namespace {

constexpr auto Name = "leitstandPlainTexts";

/// Makes labels plain when Qt polishes them, before their first layout. Tooltips are labels, too.
class PlainTexts final : public QObject {
public:
    explicit PlainTexts(QObject* parent) : QObject(parent) { setObjectName(QLatin1String(Name)); }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Polish) return false;
        auto* label = qobject_cast<QLabel*>(watched);
        if (label != nullptr && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
        return false;
    }
};

}  // namespace

void keepTextsPlain() {
    if (qApp->findChild<QObject*>(QLatin1String(Name), Qt::FindDirectChildrenOnly) != nullptr) return;
    qApp->installEventFilter(new PlainTexts(qApp));
}

QString inLines(const QString& text, int letters) {
    QTextBoundaryFinder places(QTextBoundaryFinder::Line, text);
    QString lines;
    qsizetype begin = 0, last = 0;
    for (qsizetype place = places.toNextBoundary(); place >= 0; place = places.toNextBoundary()) {
        if (place - begin > letters && last > begin) {
            lines += QStringView(text).mid(begin, last - begin).trimmed();
            lines += QLatin1Char('\n');
            begin = last;
        }
        last = place;
        if (text[place - 1] != QLatin1Char('\n')) continue;
        lines += QStringView(text).mid(begin, place - begin);
        begin = place;
    }
    lines += QStringView(text).mid(begin);
    return lines;
}

}  // namespace leitstand
