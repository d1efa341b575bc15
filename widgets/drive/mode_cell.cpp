#include "widgets/drive/mode_cell.h"

#include <QRegularExpression>
#include <QToolButton>

#include "widgets/drive/gauge.h"

namespace leitstand {
namespace {

using Choice = GrantFigures::Choice;

constexpr double Left = 18.0, Right = 10.0;  ///< [px]
constexpr double ButtonHeight = 24.0;        ///< [px]

}  // namespace

ModeCell::ModeCell(QWidget* parent)
    : QWidget(parent), m_first(new QToolButton(this)), m_second(new QToolButton(this)) {
    for (QToolButton* button : {m_first, m_second}) {
        button->setFocusPolicy(Qt::TabFocus);
        button->hide();
    }
    m_first->setObjectName(QStringLiteral("grant"));
    m_second->setObjectName(QStringLiteral("refuse"));
    m_second->setText(tr("Keep"));
    m_second->setToolTip(tr("Refuses: this station goes on driving"));
    connect(m_first, &QToolButton::clicked, this, [this] {
        switch (m_state.grant.choice) {
            case Choice::Ask:
                return emit grantAsked();
            case Choice::Asked:
            case Choice::GiveUp:
                return emit grantGivenUp();
            case Choice::Answer:
                return emit grantAnswered(true);
            case Choice::None:
                return;
        }
    });
    connect(m_second, &QToolButton::clicked, this, [this] { emit grantAnswered(false); });
}

void ModeCell::show(const DriveState& state) {
    const bool otherChoice = m_state.grant.choice != state.grant.choice;
    m_state = state;
    if (otherChoice) placeButtons();
    setAccessibleName(tr("Mode of %1").arg(state.face.title));
    setAccessibleDescription(
        QStringList{state.mode.text, state.hint, state.grant.text}.join(QStringLiteral(". ")));
    setToolTip(
        QStringList{state.mode.text, state.mode.reason, state.hint, state.grant.text, state.tracks.text}
            .filter(QRegularExpression(QStringLiteral(".")))
            .join(QLatin1Char('\n')));
    update();
}

QRectF ModeCell::grantLine() const {
    return {Left, 92.0, width() - Left - Right, ButtonHeight};
}

void ModeCell::placeButtons() {
    const Choice choice = m_state.grant.choice;
    switch (choice) {
        case Choice::Ask:
            m_first->setText(tr("Ask"));
            m_first->setToolTip(tr("Asks for the grant to drive this robot"));
            break;
        case Choice::Asked:
            m_first->setText(tr("Cancel"));
            m_first->setToolTip(tr("Asks no more"));
            break;
        case Choice::GiveUp:
            m_first->setText(tr("Give up"));
            m_first->setToolTip(tr("Gives the grant to drive up: others may take it"));
            break;
        case Choice::Answer:
            m_first->setText(tr("Give"));
            m_first->setToolTip(tr("Consents: the other station drives"));
            break;
        case Choice::None:
            break;
    }
    m_first->setAccessibleName(m_first->toolTip());
    m_second->setAccessibleName(m_second->toolTip());
    m_first->setVisible(choice != Choice::None);
    m_second->setVisible(choice == Choice::Answer);
    double right = grantLine().right();
    for (QToolButton* button : {m_second, m_first}) {
        if (button->isHidden()) continue;
        const int width = button->sizeHint().width();
        button->setGeometry(static_cast<int>(right) - width, static_cast<int>(grantLine().top()), width,
                            static_cast<int>(ButtonHeight));
        right -= width + 6.0;
    }
}

void ModeCell::resizeEvent(QResizeEvent* /*event*/) {
    placeButtons();
}

void ModeCell::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    paintModeSurface(painter, rect(), m_state.mode.kind, colours);
    painter.fillRect(QRect(0, 0, 4, height()), colours.robot(m_state.face.place));
    const QColor ink = modeInk(m_state.mode.kind, colours);
    const bool red = m_state.mode.kind == ModeKind::Stop;
    // On red, words are white: amber and grey would not be read there.
    const auto on = [&](Tone tone) { return red ? QColor(Qt::white) : toneColour(tone, colours); };
    const double inner = width() - Left - Right;

    paintCaption(painter, {Left, 8, inner, 18}, tr("%1 mode").arg(m_state.face.title), on(Tone::Muted));
    painter.setFont(fitted(painter.font(), m_state.mode.text, inner, 28, 15));
    painter.setPen(ink);
    painter.drawText(QRectF(Left, 24, inner, 36), Qt::AlignLeft | Qt::AlignVCenter, m_state.mode.text);
    painter.setFont(sized(painter.font(), 13));
    painter.setPen(on(m_state.hintTone));
    paintWrapped(painter, {Left, 60, inner, 32}, m_state.hint, 2);

    if (m_state.grant.choice != Choice::None) {
        QRectF line = grantLine();
        line.setRight((m_first->isHidden() ? line.right() : m_first->x()) - 6.0);
        paintCaption(painter, line, m_state.grant.text, on(m_state.grant.tone));
    }
    if (const double low = grantLine().bottom();
        height() - 54.0 - low >= 18.0 && !m_state.tracks.text.isEmpty()) {
        paintCaption(painter, {Left, low + 1.0, inner, 17.0},
                     m_state.tracks.note.isEmpty() ? m_state.tracks.text : m_state.tracks.note,
                     on(m_state.tracks.tone));
    }
    // Numbers stand at the bottom whatever the height; their captions go first when it is small.
    const double column = inner / 3.0, bottom = height() - 8.0;
    const bool captions = bottom - 46.0 >= grantLine().bottom();
    ThemeColours onRed = colours;
    if (red) onRed.text = onRed.muted = onRed.attention = onRed.act = QColor(Qt::white);
    const std::pair<QString, const Figure*> figures[] = {
        {tr("speed"), &m_state.speed}, {tr("turn"), &m_state.turn}, {tr("nearest"), &m_state.nearest}};
    double x = Left;
    for (const auto& [caption, figure] : figures) {
        if (captions) paintCaption(painter, {x, bottom - 46.0, column - 4.0, 16.0}, caption, on(Tone::Muted));
        paintFigure(painter, {x, bottom - 28.0, column - 4.0, 28.0}, *figure, FigureSize,
                    red ? onRed : colours);
        x += column;
    }
}

}  // namespace leitstand
