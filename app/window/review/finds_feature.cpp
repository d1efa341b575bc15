#include "app/window/review/finds_feature.h"

#include <map>
#include <utility>

#include <QAction>
#include <QInputDialog>
#include <QKeySequence>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/live/pane_docks.h"
#include "app/window/live/selection.h"
#include "app/window/review/review_bridge.h"
#include "widgets/models/timeline/timeline_words.h"
#include "widgets/review/finds_panel.h"
#include "widgets/victims/victim_form.h"

namespace leitstand {

FindsFeature::FindsFeature(const ViewContext& context, ReviewBridge& bridge)
    : QObject(&context.window),
      m_context(context),
      m_bridge(bridge),
      m_panel(new FindsPanel(&context.window)),
      m_form(new VictimForm(&context.window)) {
    context.panes.add(QStringLiteral("finds"), tr("Finds"), *m_panel);
    m_form->setObjectName(QStringLiteral("formPane"));
    context.panes.add(QStringLiteral("form"), tr("Form"), *m_form);
    addCommands();
    connect(m_form, &VictimForm::edited, this, &FindsFeature::correct);
    connect(m_panel, &FindsPanel::sought, this, [this](Time at) { m_bridge.player().seek(at); });
    connect(m_panel, &FindsPanel::confirmed, this,
            [this](const FindKey& find) { judge(find, VictimSample::Status::Confirmed); });
    connect(m_panel, &FindsPanel::discarded, this,
            [this](const FindKey& find) { judge(find, VictimSample::Status::Discarded); });
    connect(m_panel, &FindsPanel::formWanted, this, &FindsFeature::openForm);
    connect(m_panel, &FindsPanel::noteWanted, this, &FindsFeature::askForNote);
    connect(m_panel, &FindsPanel::undone, this, [this] { undo(); });
    connect(&bridge, &MomentSource::ticked, this, &FindsFeature::show);
}

FindsFeature::~FindsFeature() = default;

void FindsFeature::addCommands() {
    QAction& note = m_context.commands.add({.id = QStringLiteral("review.note"),
                                            .menu = CommandMenu::Mission,
                                            .text = tr("Write a n&ote…"),
                                            .hint = tr("About the moment that is shown"),
                                            .keys = QKeySequence(Qt::CTRL | Qt::Key_N)});
    connect(&note, &QAction::triggered, this, &FindsFeature::askForNote);
    QAction& undo = m_context.commands.add({.id = QStringLiteral("review.undo"),
                                            .menu = CommandMenu::Mission,
                                            .text = tr("&Undo what was written"),
                                            .hint = tr("Takes back what was written last in this review"),
                                            .keys = QKeySequence::Undo});
    connect(&undo, &QAction::triggered, this, &FindsFeature::undo);
}

std::optional<FindKey> FindsFeature::chosen() const {
    return m_panel->chosen();
}

const MissionState& FindsFeature::state() const {
    // What was written counts as finished: then is then.
    const bool finished = m_bridge.player().map() == ReviewMap::Finished;
    if (!finished) return *m_bridge.reviewed()->mission;
    const MissionStatePtr written = m_bridge.pen().state();
    return written ? *written : *m_bridge.index()->finished;
}

const VictimSample* FindsFeature::newest(const FindKey& find) const {
    const MissionStatePtr written = m_bridge.pen().state();
    const MissionState& now = written ? *written : *m_bridge.index()->finished;
    const auto found = now.victims->find(find);
    return found == now.victims->end() ? nullptr : &found->second.victim;
}

void FindsFeature::show() {
    if (!m_bridge.reviewed()) return;
    m_panel->show(findRowsOf(state()));
    m_panel->setUndoable(m_bridge.pen().canUndo());
    const auto chosen = m_panel->chosen();
    const VictimSample* const known = chosen ? newest(*chosen) : nullptr;
    m_form->show(known == nullptr ? std::nullopt : std::optional(*known));
}

void FindsFeature::write(std::function<Result<void>(ReviewPen&)> what, const QString& done) {
    m_bridge.write(*this, std::move(what), [this, done](const Result<void>& result) {
        if (!result) m_form->show(std::nullopt);  // then as the mission has it, not as it was wished
        emit told(result ? done : QString::fromStdString(result.error().text));
        if (result) emit marksChanged(m_bridge.pen().marks());
        show();
    });
}

void FindsFeature::undo() {
    write([](ReviewPen& pen) { return pen.undo(); }, tr("Taken back"));
}

void FindsFeature::judge(const FindKey& find, VictimSample::Status status) {
    const VictimSample* const known = newest(find);
    if (known == nullptr) return emit told(tr("The mission took this find back later"));
    VictimSample judged = *known;
    judged.status = status;
    if (status != VictimSample::Status::Discarded) judged.mergedInto = 0;
    const QString name = QString::fromStdString(nameOf(judged.kind, judged.number));
    write(
        [judged](ReviewPen& pen) {
            // What was written since, and is not shown yet, stays.
            VictimSample whole = judged;
            const MissionStatePtr written = pen.state();
            const auto found = written ? written->victims->find({judged.kind, judged.number})
                                       : std::map<FindKey, VictimState>::const_iterator();
            if (written && found != written->victims->end()) whole = found->second.victim;
            whole.status = judged.status;
            whole.mergedInto = judged.mergedInto;
            return pen.correct(whole);
        },
        tr("%1: %2 (as finished)").arg(name, statusText(judged)));
}

void FindsFeature::openForm(const FindKey& find) {
    const VictimSample* const known = newest(find);
    if (known == nullptr) return emit told(tr("The mission took this find back later"));
    if (!m_context.panes.isPaneVisible(QStringLiteral("form")))
        m_context.panes.visibility(QStringLiteral("form"))->trigger();
    m_form->show(*known);
    m_form->nextField(1);
}

void FindsFeature::correct(const VictimSample& corrected) {
    const QString name = QString::fromStdString(nameOf(corrected.kind, corrected.number));
    write(
        [corrected](ReviewPen& pen) {
            // What was judged since, and is not shown yet, stays.
            VictimSample whole = corrected;
            const MissionStatePtr written = pen.state();
            const auto found = written ? written->victims->find({corrected.kind, corrected.number})
                                       : std::map<FindKey, VictimState>::const_iterator();
            if (written && found != written->victims->end()) {
                whole.status = found->second.victim.status;
                whole.mergedInto = found->second.victim.mergedInto;
            }
            return pen.correct(whole);
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
    write([at, robot, words = text.toStdString()](ReviewPen& pen) { return pen.note(at, robot, words); },
          tr("Noted at %1").arg(wallText(at)));
}

}  // namespace leitstand
