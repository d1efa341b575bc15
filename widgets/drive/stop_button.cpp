#include "widgets/drive/stop_button.h"

#include <QAbstractButton>
#include <QGridLayout>
#include <QHBoxLayout>

#include "widgets/drive/release_handle.h"
#include "widgets/pane_paint.h"

namespace leitstand {
namespace {

/// Red in every theme and state.
class RedButton final : public QAbstractButton {
public:
    RedButton(const QString& text, const QString& key, QWidget* parent)
        : QAbstractButton(parent), m_key(key) {
        setText(text);
        // A click on it never takes the keys from driving.
        setFocusPolicy(Qt::TabFocus);
        setCursor(Qt::PointingHandCursor);
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    }
    [[nodiscard]] QSize sizeHint() const override {
        const int text = QFontMetrics(sized(font(), 14, true)).horizontalAdvance(this->text());
        const int key = QFontMetrics(sized(font(), 12)).horizontalAdvance(m_key);
        return {text + key + 42, 32};
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const ThemeColours& colours = coloursOf(presentTheme());
        const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
        painter.setPen(hasFocus() ? QPen(colours.text, 2.0) : QPen(Qt::NoPen));
        painter.setBrush(isDown()       ? colours.stop.darker(125)
                         : underMouse() ? colours.stop.lighter(112)
                                        : colours.stop);
        painter.drawRoundedRect(box, 4, 4);
        const QFont large = sized(font(), 14, true), small = sized(font(), 12);
        const int first = QFontMetrics(large).horizontalAdvance(text());
        const int both = first + 6 + QFontMetrics(small).horizontalAdvance(m_key);
        const int left = (width() - both) / 2;
        painter.setPen(Qt::white);
        painter.setFont(large);
        painter.drawText(QRect(left, 0, first + 2, height()), Qt::AlignLeft | Qt::AlignVCenter, text());
        painter.setFont(small);
        painter.drawText(QRect(left + first + 6, 0, width(), height()), Qt::AlignLeft | Qt::AlignVCenter,
                         m_key);
    }

private:
    QString m_key;
};

}  // namespace

StopButton::StopButton(QWidget* parent) : QWidget(parent), m_handles(new QGridLayout) {
    auto* button = new RedButton(tr("STOP ALL"), tr("Esc"), this);
    button->setObjectName(QStringLiteral("stop"));
    button->setAccessibleName(tr("Stop all robots"));
    button->setToolTip(
        tr("Stops all robots and holds them until each is released (Esc, always and everywhere).\n"
           "A function of this program, no certified emergency stop."));
    connect(button, &QAbstractButton::pressed, this, &StopButton::stopRequested);
    m_handles->setSpacing(2);
    m_handles->setContentsMargins(0, 0, 0, 0);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    setFixedHeight(42);  // two handles: the window shall not move when a stop comes
    layout->addLayout(m_handles);
    layout->addWidget(button);
}

void StopButton::show(const std::vector<StopLine>& lines) {
    constexpr int Rows = 2;
    while (m_lines.size() < lines.size()) {
        auto* handle = new ReleaseHandle(this);
        handle->hide();
        const int place = static_cast<int>(m_lines.size());
        m_handles->addWidget(handle, place % Rows, place / Rows);
        connect(handle, &ReleaseHandle::held, this, &StopButton::releaseRequested);
        m_lines.push_back(handle);
    }
    for (std::size_t i = 0; i < m_lines.size(); ++i)
        m_lines[i]->show(i < lines.size() ? lines[i] : StopLine{});
}

}  // namespace leitstand
