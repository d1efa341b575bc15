#include "app/window/panes/finds/finds_feature.h"

#include <utility>

#include <QAction>
#include <QInputDialog>
#include <QKeySequence>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/panes/finds/form_pictures.h"
#include "app/window/source/review_bridge.h"
#include "core/mission/state/find_state.h"
#include "widgets/models/timeline/timeline_text.h"
#include "widgets/models/times.h"
#include "widgets/models/victims/merge_text.h"
#include "widgets/models/victims/victim_rows.h"
#include "widgets/victims/victim_form.h"
#include "widgets/victims/victims_panel.h"

namespace leitstand {
namespace {

/// Returns the find of @p shown as @p pen wrote it, so that what was written since, and is not shown yet,
/// stays. Returns @p shown when nothing was written.
FindSample asWritten(const ReviewPen& pen, const FindSample& shown) {
    const MissionStatePtr written = pen.state();
    if (!written) return shown;
    const auto found = written->finds->find({shown.kind, shown.number});
    return found == written->finds->end() ? shown : found->second.victim;
}

FindKey keyOf(const FindSample& find) {
    return {find.kind, find.number};
}

}  // namespace

FindsFeature::FindsFeature(const ReviewContext& context)
    : QObject(&context.window),
      m_context(context),
      m_bridge(context.review),
      m_panel(new VictimsPanel(&context.window, VictimsPanel::Use::Review)),
      m_form(new VictimForm(&context.window)),
      m_pictures(new FormPictures(*m_form, context.review.player().folder())) {
    m_panel->setObjectName(QStringLiteral("findsPane"));
    m_form->setObjectName(QStringLiteral("formPane"));
    addCommands();
    connect(m_form, &VictimForm::edited, this, &FindsFeature::correct);
    connect(m_form, &VictimForm::done, this, [this] {
        m_context.panes.putAway(QStringLiteral("form"));
        m_panel->setFocus();
    });
    connect(m_panel, &VictimsPanel::chosenChanged, this, &FindsFeature::show);
    connect(m_panel, &VictimsPanel::activated, this, [this] {
        if (const auto row = m_panel->chosen()) m_bridge.player().seek(row->found);
    });
    connect(&context.review, &ReviewBridge::wrote, this, &FindsFeature::notifyWritten);
    connect(&context.review, &MomentSource::ticked, this, &FindsFeature::show);
    enable();
}

FindsFeature::~FindsFeature() = default;

QWidget& FindsFeature::list() const {
    return *m_panel;
}

QWidget& FindsFeature::form() const {
    return *m_form;
}

QAction& FindsFeature::add(const char* id, const QString& text, const QString& brief, const QString& hint,
                           const QKeySequence& keys) {
    QAction& action = m_context.commands.add({.id = QString::fromLatin1(id),
                                              .menu = CommandMenu::Mission,
                                              .text = text,
                                              .hint = hint,
                                              .keys = keys});
    action.setIconText(brief);
    return action;
}

void FindsFeature::addCommands() {
    const auto ofChosen = [this](QAction& action, auto call) {
        connect(&action, &QAction::triggered, this, [this, call] {
            if (const auto find = chosen()) call(*find);
        });
        return &action;
    };
    m_confirm = &add("review.confirm", tr("Con&firm the find"), tr("Confirm"),
                     tr("The chosen find is one; the chosen candidate is filed"), Qt::Key_V);
    connect(m_confirm, &QAction::triggered, this, &FindsFeature::confirm);
    m_discard = &add("review.discard", tr("&Discard the find"), tr("Discard"),
                     tr("The chosen find, or candidate, is none"), QKeySequence(Qt::SHIFT | Qt::Key_Delete));
    connect(m_discard, &QAction::triggered, this, &FindsFeature::discard);
    m_ofChosen = {
        ofChosen(add("review.form", tr("Form of the f&ind…"), tr("Form…"),
                     tr("The chosen find's form: what is known of it")),
                 [this](const FindKey& find) { openForm(find); }),
        ofChosen(
            add("review.merge", tr("&Merge with the nearest"), tr("Merge"),
                tr("The chosen find is the same as the nearest one of its kind, which gets its evidence")),
            [this](const FindKey& find) { merge(find); })};
    QAction& note = add("review.note", tr("Write a n&ote…"), tr("Note…"),
                        tr("About the moment that is shown"), QKeySequence(Qt::CTRL | Qt::Key_N));
    connect(&note, &QAction::triggered, this, &FindsFeature::askForNote);
    m_undo = &add("review.undo", tr("&Undo what was written"), tr("Undo"),
                  tr("Takes back what was written last in reviews"),
                  QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_U));
    m_undo->setShortcuts({m_undo->shortcut(), QKeySequence::Undo});
    connect(m_undo, &QAction::triggered, this, &FindsFeature::undo);
    m_panel->addCommands({m_confirm, m_discard});
    m_panel->addCommands(m_ofChosen);
    m_panel->addCommands({m_undo, &note});
}

void FindsFeature::offer(QAction& action, Of of) {
    if (of == Of::Chosen) m_ofChosen.push_back(&action);
    m_panel->addCommands({&action});
    enable();
}

std::optional<FindKey> FindsFeature::chosen() const {
    const auto row = m_panel->chosen();
    return row && row->filed() ? std::optional(row->find) : std::nullopt;
}

const MissionState& FindsFeature::state() const {
    // What was written counts as finished. The past moment stays as it was.
    return m_bridge.player().map() == ReviewMap::Finished ? finished() : *m_bridge.reviewed()->mission;
}

const MissionState& FindsFeature::finished() const {
    m_written = m_bridge.pen().state();
    return m_written ? *m_written : *m_bridge.index()->finished;
}

const FindSample* FindsFeature::newest(const FindKey& find) const {
    const MissionState& now = finished();
    const auto found = now.finds->find(find);
    return found == now.finds->end() ? nullptr : &found->second.victim;
}

void FindsFeature::enable() {
    m_undo->setEnabled(m_bridge.pen().canUndo());
    for (QAction* action : {m_confirm, m_discard}) action->setEnabled(m_panel->chosen().has_value());
    for (QAction* action : m_ofChosen) action->setEnabled(chosen().has_value());
}

void FindsFeature::show() {
    if (!m_bridge.reviewed()) return;
    m_moves.follow(state());
    std::vector<VictimRow> rows = filedRows(state(), &m_moves);
    const std::vector<VictimRow> candidates = candidateRows(state(), std::nullopt);
    rows.insert(rows.end(), candidates.begin(), candidates.end());
    m_panel->show(rows);
    enable();
    const auto find = chosen();
    if (find != m_corrected) m_corrected.reset();
    showForm(inForm(find));
    emit findsChanged();
}

std::optional<FindSample> FindsFeature::inForm(const std::optional<FindKey>& find) const {
    if (!find) return std::nullopt;
    if (find == m_corrected) {
        const FindSample* const known = newest(*find);
        return known == nullptr ? std::nullopt : std::optional(*known);
    }
    const MissionState& shown = state();
    const auto known = shown.finds->find(*find);
    return known == shown.finds->end() ? std::nullopt : std::optional(known->second.victim);
}

void FindsFeature::showForm(const std::optional<FindSample>& find) {
    m_form->show(find);  // may emit what was being typed for the find before
    m_shown = find;
    if (m_form->isVisible()) m_pictures->follow(find);
}

void FindsFeature::notifyWritten(const QString& done, const QString& problem) {
    const bool failed = !problem.isEmpty();
    if (failed) showForm(std::nullopt);  // shows the mission's state again, not the failed edit
    if (const auto asked = std::exchange(m_asked, std::nullopt); asked && !failed) m_corrected = asked;
    m_context.notify(failed ? problem : done);
    if (!failed) emit marksChanged(m_bridge.pen().marks());
    show();
}

void FindsFeature::undo() {
    m_bridge.write([](ReviewPen& pen) { return pen.undo(); }, tr("Taken back"));
}

void FindsFeature::confirm() {
    const auto row = m_panel->chosen();
    if (!row) return;
    if (row->filed()) return judge(row->find, FindSample::Status::Confirmed);
    m_bridge.write([candidate = row->candidate](ReviewPen& pen) { return pen.fileCandidate(candidate); },
                   tr("The candidate is filed (as finished)"));
}

void FindsFeature::discard() {
    const auto row = m_panel->chosen();
    if (!row) return;
    if (row->filed()) return judge(row->find, FindSample::Status::Discarded);
    m_bridge.write([candidate = row->candidate](ReviewPen& pen) { return pen.dismiss(candidate); },
                   tr("The candidate is dismissed (as finished)"));
}

void FindsFeature::judge(const FindKey& find, FindSample::Status status) {
    const FindSample* const known = newest(find);
    if (known == nullptr) return m_context.notify(tr("The mission took this find back later"));
    FindSample judged = *known;
    judged.status = status;
    if (status != FindSample::Status::Discarded) judged.mergedInto = 0;
    const QString name = QString::fromStdString(nameOf(judged.kind, judged.number));
    m_bridge.write(
        [judged](ReviewPen& pen) {
            FindSample whole = asWritten(pen, judged);
            whole.status = judged.status;
            whole.mergedInto = judged.mergedInto;
            return pen.correct(whole);
        },
        tr("%1: %2 (as finished)").arg(name, statusText(judged)));
}

void FindsFeature::merge(const FindKey& find) {
    const MergeOffer offer = mergeOffer(finished(), find);
    if (!offer.into) return m_context.notify(offer.text);
    m_bridge.write([find, into = *offer.into](ReviewPen& pen) { return pen.merge(find, into); }, offer.text);
}

void FindsFeature::openForm(const FindKey& find) {
    const FindSample* const known = newest(find);
    if (known == nullptr) return m_context.notify(tr("The mission took this find back later"));
    if (!m_context.panes.isPaneVisible(QStringLiteral("form")))
        m_context.panes.visibility(QStringLiteral("form"))->trigger();
    m_corrected = find;
    showForm(*known);
    m_form->nextField(1);
}

void FindsFeature::correct(const FindSample& corrected) {
    const QString name = QString::fromStdString(nameOf(corrected.kind, corrected.number));
    const FindKey find = keyOf(corrected);
    const FindSample* const known = newest(find);
    if (known == nullptr) return m_context.notify(tr("The mission took this find back later"));
    // The form may have shown an old state: only what was changed there is written.
    const FindSample before = m_shown && keyOf(*m_shown) == find ? *m_shown : *known;
    m_asked = find;
    m_bridge.write(
        [before, corrected, known = *known](ReviewPen& pen) {
            return pen.correct(withEdits(asWritten(pen, known), before, corrected));
        },
        tr("%1 corrected (as finished)").arg(name));
}

void FindsFeature::askForNote() {
    const Time at = m_bridge.player().position();
    auto* question = new QInputDialog(&m_context.window);
    question->setObjectName(QStringLiteral("reviewNote"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setWindowTitle(tr("Note"));
    question->setLabelText(tr("About %1").arg(wallText(at)));
    connect(question, &QInputDialog::textValueSelected, this,
            [this, at](const QString& text) { note(at, text.trimmed()); });
    question->show();
}

void FindsFeature::note(Time at, const QString& text) {
    if (text.isEmpty()) return;
    const std::string robot = m_context.selection.name().toStdString();
    m_bridge.write(
        [at, robot, words = text.toStdString()](ReviewPen& pen) { return pen.note(at, robot, words); },
        tr("Noted at %1").arg(wallText(at)));
}

}  // namespace leitstand
