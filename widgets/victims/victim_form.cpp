#include "widgets/victims/victim_form.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/models/numbers.h"
#include "widgets/models/victims/victim_rows.h"
#include "widgets/victims/evidence_strip.h"
#include "widgets/victims/hint_line.h"

namespace leitstand {
namespace {

void setText(QLineEdit& line, const QString& text) {
    if (line.text() != text && !(line.hasFocus() && line.isModified())) line.setText(text);
}

void setChoice(QComboBox& box, const QString& word) {
    const int index = box.findData(word);
    if (index < 0 && !word.isEmpty()) box.addItem(word, word);  // a word from another program
    box.setCurrentIndex(box.findData(word));
}

QComboBox* choiceBox(QWidget& parent, const QString& name, const std::vector<VictimChoice>& choices) {
    auto* box = new QComboBox(&parent);
    box->setAccessibleName(name);
    for (const VictimChoice& choice : choices) box->addItem(choice.text, QString::fromStdString(choice.word));
    return box;
}

}  // namespace

VictimForm::VictimForm(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_pictures(new EvidenceStrip(this)),
      m_situation(choiceBox(*this, tr("Situation"), situationChoices())),
      m_area(choiceBox(*this, tr("Area"), areaChoices())),
      m_tag(line(tr("Tag"), {tr("what is written on it")})),
      m_text(line(tr("Remarks"), {tr("how to get there, what to mind")})) {
    setAccessibleName(tr("Form of the chosen find"));
    m_situation->setObjectName(QStringLiteral("situation"));
    m_situation->setToolTip(tr("How the victim lies there"));
    m_area->setObjectName(QStringLiteral("area"));
    m_area->setToolTip(tr("Where the find is; unknown: in the area of the mission"));
    m_tag->setObjectName(QStringLiteral("tag"));
    m_text->setObjectName(QStringLiteral("remarks"));
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 4, 0, 0);
    rows->setSpacing(4);
    addHead(*rows);
    // A low pane scrolls and follows the focus.
    m_grid = new QWidget;
    auto* area = new QScrollArea(this);
    area->setWidget(m_grid);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    rows->addWidget(m_pictures, 1);
    rows->addWidget(area);
    auto* grid = new QGridLayout(m_grid);
    grid->setContentsMargins(8, 0, 8, 8);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(2, 1);
    addSigns(*grid);
    addRest(*grid);
    grid->setRowStretch(grid->rowCount(), 1);
    connect(m_situation, &QComboBox::currentIndexChanged, this, &VictimForm::read);
    connect(m_area, &QComboBox::currentIndexChanged, this, &VictimForm::read);
    show(std::nullopt);
}

QSize VictimForm::sizeHint() const {
    return {minimumSizeHint().width() + 20, 368};
}

QSize VictimForm::minimumSizeHint() const {
    constexpr int Least = 420;  ///< [px]
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    return {std::max(Least, m_grid->minimumSizeHint().width() + bar), 110};
}

void VictimForm::addHead(QVBoxLayout& rows) {
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 0, 8, 0);
    m_title->setWordWrap(true);
    auto* done = new QToolButton(this);
    done->setObjectName(QStringLiteral("formDone"));
    done->setText(tr("Done"));
    done->setToolTip(tr("Closes the form; what was filled in is kept already"));
    done->setFocusPolicy(Qt::TabFocus);  // a click keeps the focus in the field being typed in
    connect(done, &QToolButton::clicked, this, &VictimForm::done);
    head->addWidget(m_title, 1);
    head->addWidget(done);
    rows.addLayout(head);
}

QLabel* VictimForm::label(const QString& text, QWidget* field) {
    auto* name = new QLabel(text, this);
    name->setBuddy(field);
    name->setProperty("muted", true);
    return name;
}

void VictimForm::addSigns(QGridLayout& grid) {
    int row = 0;
    for (const SignField& field : signFields()) {
        auto* state = new QComboBox(this);
        state->setAccessibleName(field.name);
        using State = VictimSign::State;
        for (const State one : {State::Unknown, State::Absent, State::Present})
            state->addItem(signStateText(one), static_cast<int>(one));
        auto* text = line(tr("%1, in words").arg(field.name), field.words, true);
        QLineEdit* value = nullptr;
        grid.addWidget(label(field.name, state), row, 0);
        grid.addWidget(state, row, 1);
        grid.addWidget(text, row, 2, 1, field.unit.isEmpty() ? 2 : 1);
        m_fields.insert(m_fields.end(), {state, text});
        if (!field.unit.isEmpty()) {
            value = line(tr("%1, measured").arg(field.name), {field.unit});
            value->setMaximumWidth(64);
            grid.addWidget(value, row, 3);
            m_fields.push_back(value);
        }
        m_signs.push_back({field, state, text, value});
        connect(state, &QComboBox::currentIndexChanged, this, &VictimForm::read);
        ++row;
    }
}

/// Adds the other fields, two per row to keep the form low.
void VictimForm::addRest(QGridLayout& grid) {
    const auto pair = [&](const QString& one, QWidget* first, const QString& two, QWidget* second) {
        const int row = grid.rowCount();
        auto* both = new QHBoxLayout;
        both->setSpacing(8);
        both->addWidget(first, 1);
        both->addWidget(label(two, second));
        both->addWidget(second, 1);
        grid.addWidget(label(one, first), row, 0);
        grid.addLayout(both, row, 1, 1, 3);
        m_fields.insert(m_fields.end(), {first, second});
    };
    pair(tr("Situation"), m_situation, tr("Tag"), m_tag);
    pair(tr("Area"), m_area, tr("Remarks"), m_text);
}

void VictimForm::setPictures(std::vector<EvidenceImage> pictures, bool awaited) {
    m_pictures->setVisible(awaited || !pictures.empty());
    m_pictures->show(std::move(pictures), awaited);
}

QLineEdit* VictimForm::line(const QString& name, const QStringList& hints, bool more) {
    auto* made = new HintLine(this);
    made->setAccessibleName(name);
    made->setHints(hints, more);
    made->setToolTip(more ? tr("%1: %2").arg(name, hintText(hints, more)) : name);
    made->setMaxLength(200);
    connect(made, &QLineEdit::editingFinished, this, &VictimForm::read);
    return made;
}

void VictimForm::setEnabledParts(bool on) {
    const bool victim = on && m_find->kind == FindSample::Kind::Victim;
    for (const Sign& sign : m_signs) {
        sign.state->setEnabled(victim);
        sign.text->setEnabled(victim);
        if (sign.value != nullptr) sign.value->setEnabled(victim);
    }
    m_situation->setEnabled(victim);
    for (QWidget* field : std::initializer_list<QWidget*>{m_area, m_tag, m_text}) field->setEnabled(on);
}

void VictimForm::show(const std::optional<FindSample>& find) {
    const bool same = m_find && find && m_find->kind == find->kind && m_find->number == find->number;
    if (same && m_edited && find->stamp == *m_edited) return;  // older than the edit
    // Typed text belongs to the old find: it is applied before another one is shown.
    if (!same && focusWidget() != nullptr && isAncestorOf(focusWidget())) focusWidget()->clearFocus();
    m_edited.reset();
    m_showing = true;  // values set here are no edits
    m_find = find;
    m_title->setText(find ? tr("%1 · %2").arg(QString::fromStdString(nameOf(find->kind, find->number)),
                                              kindText(find->kind))
                          : tr("Choose a find to fill in its form"));
    if (!same) setPictures({});
    setEnabledParts(find.has_value());
    const FindSample shown = find.value_or(FindSample());
    for (const Sign& sign : m_signs) {
        const VictimSign& value = shown.*sign.field.sign;
        sign.state->setCurrentIndex(sign.state->findData(static_cast<int>(value.state)));
        setText(*sign.text, QString::fromStdString(value.text));
        if (sign.value != nullptr)
            setText(*sign.value,
                    std::isnan(value.value) ? QString() : QLocale().toString(value.value, 'f', 0));
    }
    setChoice(*m_situation, QString::fromStdString(shown.situation));
    setChoice(*m_area, QString::fromStdString(shown.area));
    setText(*m_tag, QString::fromStdString(shown.tag));
    setText(*m_text, QString::fromStdString(shown.text));
    m_showing = false;
}

// A field that is destroyed with the focus emits editingFinished, when this is no longer a VictimForm.
VictimForm::~VictimForm() {
    for (QWidget* field : m_fields) field->disconnect(this);
}

void VictimForm::hideEvent(QHideEvent* event) {
    // Text from other programs may exceed the form's limit: unedited text stays.
    const auto* const typed = qobject_cast<const QLineEdit*>(focusWidget());
    if (typed != nullptr && typed->isModified()) read();
    QWidget::hideEvent(event);
}

void VictimForm::read() {
    if (m_showing || !m_find) return;
    FindSample now = *m_find;
    bool changed = false;
    const auto put = [&changed](auto& to, const auto& from) {
        changed = changed || to != from;
        to = from;
    };
    for (const Sign& sign : m_signs) {
        VictimSign& value = now.*sign.field.sign;
        put(value.state, static_cast<VictimSign::State>(sign.state->currentData().toInt()));
        put(value.text, sign.text->text().trimmed().toStdString());
        if (sign.value == nullptr) continue;
        bool number = false;
        const double measured = QLocale().toDouble(sign.value->text().trimmed(), &number);
        const double before = value.value;
        if (number && std::isfinite(measured)) {
            if (std::isnan(before) || std::lround(before) != std::lround(measured))
                put(value.value, measured);
        } else if (sign.value->text().trimmed().isEmpty() && !std::isnan(before)) {
            value.value = Unknown;
            changed = true;
        }
    }
    put(now.situation, m_situation->currentData().toString().toStdString());
    put(now.area, m_area->currentData().toString().toStdString());
    put(now.tag, m_tag->text().trimmed().toStdString());
    put(now.text, m_text->text().trimmed().toStdString());
    for (QWidget* field : m_fields) {
        if (auto* one = qobject_cast<QLineEdit*>(field)) one->setModified(false);
    }
    if (!changed) return;
    m_edited = m_find->stamp;
    m_find = now;
    emit edited(now);
}

void VictimForm::nextField(int step) {
    const auto count = static_cast<int>(m_fields.size());
    int at = step > 0 ? -1 : 0;
    for (int i = 0; i < count; ++i) {
        if (m_fields[static_cast<std::size_t>(i)]->hasFocus()) at = i;
    }
    for (int i = 0; i < count; ++i) {
        at = (at + step + count) % count;
        QWidget* field = m_fields[static_cast<std::size_t>(at)];
        if (!field->isEnabled()) continue;
        field->setFocus(Qt::TabFocusReason);
        findChild<QScrollArea*>()->ensureWidgetVisible(field);
        return;
    }
}

bool VictimForm::changeLine(QLineEdit& field, int step) {
    if (!field.isEnabled()) return false;
    QStringList words = &field == m_tag ? m_tags : &field == m_text ? remarkChoices() : QStringList();
    for (const Sign& sign : m_signs) {
        if (&field == sign.value) return changeValue(sign, step);
        if (&field == sign.text) words = sign.field.words;
    }
    words.prepend(QString());  // the empty choice
    const auto at = words.indexOf(field.text().trimmed());
    if (at < 0 || words.size() == 1) return false;
    field.setText(words[(at + step + words.size()) % words.size()]);
    read();
    return true;
}

bool VictimForm::changeValue(const Sign& sign, int step) {
    const SignField::Range& range = sign.field.range;
    const QString text = sign.value->text().trimmed();
    bool number = false;
    double value = QLocale().toDouble(text, &number);
    if (!number && !text.isEmpty()) return false;
    value = number ? value + step * range.step : range.usual;
    if (value > range.most) value = range.least;
    if (value < range.least) value = range.most;
    sign.value->setText(QLocale().toString(value, 'f', 0));
    read();
    return true;
}

bool VictimForm::change(int step) {
    if (auto* field = qobject_cast<QLineEdit*>(focusWidget())) return changeLine(*field, step);
    auto* box = qobject_cast<QComboBox*>(focusWidget());
    if (box == nullptr || !box->isEnabled() || box->count() == 0) return false;
    box->setCurrentIndex((box->currentIndex() + step + box->count()) % box->count());
    return true;
}

}  // namespace leitstand
