#include "widgets/preflight/preflight_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include "widgets/models/others_text.h"
#include "widgets/painting/pane_paint.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {
namespace {

constexpr int HoldRhythm = 50;  ///< [ms]

QLabel* caption(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setFont(sized(label->font(), 13, true));
    return label;
}

/// Fills @p box with @p texts if they changed; the choice is kept.
void fill(QComboBox& box, const std::vector<std::pair<QString, QString>>& texts) {
    bool same = box.count() == static_cast<int>(texts.size());
    for (int i = 0; same && i < box.count(); ++i)
        same = box.itemData(i).toString() == texts[static_cast<std::size_t>(i)].second;
    if (same) return;
    const QVariant chosen = box.currentData();
    const QSignalBlocker quiet(box);
    box.clear();
    for (const auto& [text, data] : texts) box.addItem(text, data);
    if (const int place = box.findData(chosen); place >= 0) box.setCurrentIndex(place);
}

}  // namespace

PreflightPage::PreflightPage(QWidget* parent)
    : QWidget(parent), m_table(new QTableView(this)), m_rhythm(new QTimer(this)) {
    setObjectName(QStringLiteral("preflight"));
    m_table->setObjectName(QStringLiteral("checks"));
    m_table->setAccessibleName(tr("Checks before the mission"));
    m_table->setModel(&m_list);
    dressTable(*m_table);
    m_table->setWordWrap(true);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->verticalHeader()->setMinimumSectionSize(24);
    auto* header = m_table->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setSectionResizeMode(PreflightList::Who, QHeaderView::ResizeToContents);
    header->setSectionResizeMode(PreflightList::What, QHeaderView::Stretch);
    header->setSectionResizeMode(PreflightList::Remedy, QHeaderView::Stretch);
    m_table->setColumnWidth(PreflightList::State, 36);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 12);
    layout->setSpacing(8);
    layout->addWidget(head());
    layout->addWidget(m_table, 1);
    layout->addWidget(brakes());
    layout->addWidget(robots());
    m_rhythm->setInterval(HoldRhythm);
    connect(m_rhythm, &QTimer::timeout, this, [this] { emit brakeHeld(m_tested); });
}

QWidget* PreflightPage::head() {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    m_verdict = new QLabel(row);
    m_verdict->setObjectName(QStringLiteral("verdict"));
    m_verdict->setFont(sized(m_verdict->font(), 18, true));
    auto* again = new QPushButton(tr("Check again"), row);
    again->setObjectName(QStringLiteral("again"));
    again->setToolTip(tr("Measures the disk again; everything else is checked once a second"));
    connect(again, &QPushButton::clicked, this, &PreflightPage::checkAgainWanted);
    auto* tones = new QPushButton(tr("Try the tones"), row);
    tones->setObjectName(QStringLiteral("tones"));
    tones->setToolTip(tr("Plays the tones of alarms: to look, then to act"));
    connect(tones, &QPushButton::clicked, this, &PreflightPage::tonesWanted);
    line->addWidget(m_verdict, 1);
    line->addWidget(tones);
    line->addWidget(again);
    return row;
}

QWidget* PreflightPage::brakes() {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    m_robot = new QComboBox(row);
    m_robot->setObjectName(QStringLiteral("brakeRobot"));
    m_robot->setAccessibleName(tr("Robot whose brake is tested"));
    m_robot->setToolTip(m_robot->accessibleName());
    m_test = new QPushButton(tr("Hold to test the brake"), row);
    m_test->setObjectName(QStringLiteral("brakeTest"));
    m_test->setToolTip(
        tr("Drives 0.1 m/s ahead for a second at most, then sends nothing and measures when the "
           "robot stands. Letting go ends it; Esc stops all."));
    m_test->installEventFilter(this);
    m_brakeText = new QLabel(row);
    m_brakeText->setObjectName(QStringLiteral("brakeText"));
    m_brakeText->setWordWrap(true);
    m_override = new QCheckBox(tr("Drive it nevertheless"), row);
    m_override->setObjectName(QStringLiteral("override"));
    m_override->setToolTip(tr("This robot goes on when the radio is lost. Until the program ends."));
    connect(m_override, &QCheckBox::toggled, this,
            [this](bool on) { emit overrideWanted(brakeRobot(), on); });
    line->addWidget(caption(tr("Brake test"), row));
    line->addWidget(m_robot);
    line->addWidget(m_test);
    line->addWidget(m_brakeText, 1);
    line->addWidget(m_override);
    return row;
}

QWidget* PreflightPage::robots() {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    m_stranger = new QComboBox(row);
    m_stranger->setObjectName(QStringLiteral("stranger"));
    m_stranger->setAccessibleName(tr("Robots that are heard and not driven"));
    m_stranger->setToolTip(m_stranger->accessibleName());
    m_stranger->setMinimumContentsLength(10);
    m_add = new QPushButton(tr("Add"), row);
    m_add->setObjectName(QStringLiteral("add"));
    m_add->setToolTip(tr("Writes a first file of the robot and takes it into the station"));
    connect(m_add, &QPushButton::clicked, this,
            [this] { emit strangerWanted(m_stranger->currentData().toString()); });
    auto* file = new QPushButton(tr("From a file..."), row);
    file->setObjectName(QStringLiteral("fromFile"));
    file->setToolTip(tr("A robot file (YAML)"));
    connect(file, &QPushButton::clicked, this, &PreflightPage::fileWanted);
    line->addWidget(caption(tr("Another robot"), row));
    line->addWidget(m_stranger);
    line->addWidget(m_add);
    line->addWidget(file);
    m_complaint = new QLabel(row);
    m_complaint->setObjectName(QStringLiteral("complaint"));
    m_complaint->setProperty("attention", true);
    m_complaint->setWordWrap(true);
    line->addWidget(m_complaint, 1);
    return row;
}

void PreflightPage::complain(const QString& text) {
    m_complaint->setText(text);
}

void PreflightPage::show(std::vector<PreflightCheck> checks, const std::vector<RobotFace>& faces,
                         const QStringList& strangers) {
    std::map<std::string, RobotFace> byName;
    std::vector<std::pair<QString, QString>> names, others;
    for (const RobotFace& face : faces) {
        byName.emplace(face.name.toStdString(), face);
        names.emplace_back(face.title, face.name);
    }
    for (const QString& stranger : strangers) others.emplace_back(othersText(stranger), stranger);
    m_verdict->setText(verdictText(checks));
    m_list.setChecks(std::move(checks), std::move(byName));
    fill(*m_robot, names);
    fill(*m_stranger, others);
    m_stranger->setEnabled(!others.empty());
    m_add->setEnabled(!others.empty());
}

void PreflightPage::showBrake(const QString& text, bool refused, bool overridden) {
    m_brakeText->setText(text);
    m_override->setVisible(refused || overridden);
    const QSignalBlocker quiet(m_override);
    m_override->setChecked(overridden);
}

QString PreflightPage::brakeRobot() const {
    return m_robot->currentData().toString();
}

void PreflightPage::press() {
    if (m_rhythm->isActive() || brakeRobot().isEmpty()) return;
    m_tested = brakeRobot();
    emit brakeBegun(m_tested);
    m_rhythm->start();
}

void PreflightPage::letGo() {
    if (!m_rhythm->isActive()) return;
    m_rhythm->stop();
    emit brakeEnded(m_tested);
}

bool PreflightPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_test) return QWidget::eventFilter(watched, event);
    const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    if (key) {
        const auto* pressed = static_cast<QKeyEvent*>(event);
        const bool ours = pressed->key() == Qt::Key_Space || pressed->key() == Qt::Key_Return ||
                          pressed->key() == Qt::Key_Enter;
        if (ours && !pressed->isAutoRepeat()) event->type() == QEvent::KeyPress ? press() : letGo();
    } else if (event->type() == QEvent::MouseButtonPress) {
        press();
    } else if (event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::FocusOut ||
               event->type() == QEvent::Hide || event->type() == QEvent::WindowDeactivate) {
        letGo();
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace leitstand
