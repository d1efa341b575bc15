#include "widgets/drive/mode_cell.h"

#include <QRegularExpression>
#include <QToolButton>

#include "widgets/drive/gauge.h"

namespace leitstand {
namespace {

using Choice = GrantFigures::Choice;

constexpr double Left = 18.0, Right = 10.0;  ///< [px]
constexpr double ButtonHeight = 24.0;        ///< [px]
constexpr double Roomy = 190.0;              ///< height from which lines are spaced out [px]
constexpr double Numbers = 28.0, Captions = 18.0, TracksLine = 16.0, Hint = 31.0;  ///< heights [px]

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
    QStringList reported = {state.mode.text, state.hint, state.grant.text, state.tracks.note,
                            state.tracks.text};
    reported.removeAll(QString());
    setAccessibleDescription(reported.join(QStringLiteral(". ")));
    setToolTip(QStringList{state.mode.text, state.mode.reason, state.hint, state.grant.text,
                           state.tracks.note, state.tracks.text}
                   .filter(QRegularExpression(QStringLiteral(".")))
                   .join(QLatin1Char('\n')));
    update();
}

QRectF ModeCell::grantLine() const {
    return {Left, height() < Roomy ? 84.0 : 92.0, width() - Left - Right, ButtonHeight};
}

void ModeCell::placeButtons() {
    const Choice choice = m_state.grant.choice;
    switch (choice) {
        case Choice::Ask:
            m_first->setText(tr("Request"));
            m_first->setToolTip(tr("Requests drive control of this robot"));
            break;
        case Choice::Asked:
            m_first->setText(tr("Cancel"));
            m_first->setToolTip(tr("Withdraws the request"));
            break;
        case Choice::GiveUp:
            m_first->setText(tr("Release"));
            m_first->setToolTip(tr("Releases drive control: others may take it"));
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
    // On red, text is white: amber and grey are illegible there.
    const auto on = [&](Tone tone) { return red ? QColor(Qt::white) : toneColour(tone, colours); };
    const double inner = width() - Left - Right;
    const double grant = grantLine().top(), below = grantLine().bottom() + 1.0;
    const double numbers = height() - 8.0 - Numbers;
    const TrackFigures& tracks = m_state.tracks;
    const bool tracksFit = !tracks.text.isEmpty() && below + TracksLine <= numbers;

    paintCaption(painter, {Left, 8, inner, 18}, tr("%1 mode").arg(m_state.face.title), on(Tone::Muted));
    painter.setFont(fitted(painter.font(), m_state.mode.text, inner, height() < Roomy ? 26 : 28, 15));
    painter.setPen(ink);
    painter.drawText(QRectF(Left, 22, inner, grant - Hint - 22.0), Qt::AlignLeft | Qt::AlignVCenter,
                     m_state.mode.text);
    painter.setFont(sized(painter.font(), 13));
    // A chain that does not follow is always shown; it replaces a muted hint.
    const bool noteFirst = !tracks.note.isEmpty() && !tracksFit && m_state.hintTone == Tone::Muted;
    painter.setPen(on(noteFirst ? tracks.tone : m_state.hintTone));
    paintWrapped(painter, {Left, grant - Hint, inner, Hint}, noteFirst ? tracks.note : m_state.hint, 2);

    if (m_state.grant.choice != Choice::None) {
        QRectF line = grantLine();
        line.setRight((m_first->isHidden() ? line.right() : m_first->x()) - 6.0);
        paintCaption(painter, line, m_state.grant.text, on(m_state.grant.tone));
    }
    if (tracksFit) {
        const bool wide =
            QFontMetricsF(sized(painter.font(), CaptionSize)).horizontalAdvance(tracks.text) <= inner;
        const QString& figures = wide ? tracks.text : tracks.brief;
        paintCaption(painter, {Left, below, inner, TracksLine}, tracks.note.isEmpty() ? figures : tracks.note,
                     on(tracks.tone));
    }
    // Numbers stay at the bottom at any height; their captions go first when it is small.
    const double column = inner / 3.0;
    const bool captions = numbers - Captions >= below - 1.0 + (tracksFit ? TracksLine : 0.0);
    ThemeColours onRed = colours;
    if (red) onRed.text = onRed.muted = onRed.attention = onRed.act = QColor(Qt::white);
    const std::pair<QString, const Figure*> figures[] = {
        {tr("speed"), &m_state.speed}, {tr("turn"), &m_state.turn}, {tr("nearest"), &m_state.nearest}};
    double x = Left;
    for (const auto& [caption, figure] : figures) {
        if (captions)
            paintCaption(painter, {x, numbers - Captions, column - 4.0, 16.0}, caption, on(Tone::Muted));
        paintFigure(painter, {x, numbers, column - 4.0, Numbers}, *figure, FigureSize, red ? onRed : colours);
        x += column;
    }
}

}  // namespace leitstand
