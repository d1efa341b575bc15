#include "app/window/layouts/layout_feature.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <QAction>
#include <QActionGroup>
#include <QInputDialog>
#include <QKeySequence>
#include <QMainWindow>
#include <QMenu>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/drive_input.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_switch.h"
#include "app/window/panes/map/map_feature.h"

namespace leitstand {
namespace {

constexpr int FirstKey = Qt::Key_F5, Keys = 4;  // F9 is the preflight's

QString idOf(const std::string& name) {
    return QStringLiteral("layout.") + QString::fromStdString(name);
}

/// Returns the title of @p layout: translated when it comes with the program, unchanged when it is the
/// operator's own.
QString shownTitle(const WindowLayout& layout) {
    for (const char* title : {QT_TRANSLATE_NOOP("leitstand::LayoutFeature", "Drive"),
                              QT_TRANSLATE_NOOP("leitstand::LayoutFeature", "Explore"),
                              QT_TRANSLATE_NOOP("leitstand::LayoutFeature", "Map"),
                              QT_TRANSLATE_NOOP("leitstand::LayoutFeature", "Review"),
                              QT_TRANSLATE_NOOP("leitstand::LayoutFeature", "Link"),
                              QT_TRANSLATE_NOOP("leitstand::LayoutFeature", "Report"),
                              QT_TRANSLATE_NOOP("leitstand::LayoutFeature", "Compare")}) {
        if (layout.title == title) return LayoutFeature::tr(title);
    }
    return QString::fromStdString(layout.title);
}

/// Returns @p title as a file name: "second-screen" for "Second screen". Letters beyond ASCII become their
/// Unicode numbers.
std::string nameOf(const QString& title) {
    std::string name;
    for (const QChar letter : title.toLower()) {
        const bool plain = (letter >= u'a' && letter <= u'z') || (letter >= u'0' && letter <= u'9');
        if (plain) {
            name += letter.toLatin1();
        } else if (letter.unicode() > 0x7F) {
            name += QStringLiteral("u%1").arg(letter.unicode(), 4, 16, QLatin1Char('0')).toStdString();
        } else if (!name.empty() && name.back() != '-') {
            name += '-';
        }
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return name;
}

}  // namespace

LayoutFeature::LayoutFeature(const ViewContext& context, LayoutBook book, MapFeature& map)
    : QObject(&context.window),
      m_context(context),
      m_book(std::move(book)),
      m_map(map),
      m_sights(map.sight()),
      m_bar(new LayoutSwitch(&context.window)),
      m_choices(new QActionGroup(this)) {
    fill();
    addCommands();
    addPanes();
}

void LayoutFeature::addCommands() {
    CommandTable& commands = m_context.commands;
    commands.separate(CommandMenu::View);
    QAction& swap = commands.add({.id = "view.swap",
                                  .menu = CommandMenu::View,
                                  .text = tr("S&wap camera and map"),
                                  .hint = tr("Camera and map change places"),
                                  .keys = QKeySequence(Qt::Key_X)});
    connect(&swap, &QAction::triggered, this,
            [this] { m_context.panes.swap(QStringLiteral("camera"), QStringLiteral("map")); });
    QAction& arrange =
        commands.add({.id = "layout.arrange",
                      .menu = CommandMenu::View,
                      .text = tr("&Arrange panes"),
                      .hint = tr("Panes get titles to be dragged by, to another place or out of the "
                                 "window; again to hold them there"),
                      .checkable = true});
    connect(&arrange, &QAction::toggled, this, [this](bool on) { m_context.panes.setArranging(on); });
    QAction& save = commands.add({.id = "layout.save",
                                  .menu = CommandMenu::View,
                                  .text = tr("Save la&yout as…"),
                                  .hint = tr("Keeps how panes are now as a layout of one's own")});
    connect(&save, &QAction::triggered, this, &LayoutFeature::askForTitle);
    m_forget = &commands.add({.id = "layout.forget",
                              .menu = CommandMenu::View,
                              .text = tr("&Delete this layout"),
                              .hint = tr("Deletes the file of a layout of one's own")});
    connect(m_forget, &QAction::triggered, this, &LayoutFeature::forget);
}

void LayoutFeature::addPanes() {
    m_context.commands.separate(CommandMenu::View);
    QMenu* menu = m_context.commands.menu(CommandMenu::View).addMenu(tr("&Panes"));
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        for (const QString& id : m_context.panes.ids()) menu->addAction(m_context.panes.visibility(id));
    });
}

void LayoutFeature::fill() {
    for (QAction* choice : m_choices->actions()) choice->setVisible(false);
    m_bar->clear();
    std::vector<std::string> errors;
    int place = 0;
    for (const WindowLayout& layout : m_book.all(errors)) {
        if (isOfUse(layout)) addChoice(layout, place);
        ++place;  // the key of a layout is the same in every window
    }
    for (const std::string& error : errors) m_context.notify(QString::fromStdString(error));
}

bool LayoutFeature::isOfUse(const WindowLayout& layout) const {
    const auto named = panesIn(layout.panes);
    const auto known = std::count_if(named.begin(), named.end(), [&](const std::string& id) {
        return m_context.panes.has(QString::fromStdString(id));
    });
    return 2 * known > static_cast<std::ptrdiff_t>(named.size());
}

void LayoutFeature::addChoice(const WindowLayout& layout, int place) {
    const QString id = idOf(layout.name), title = shownTitle(layout);
    QAction* choice = m_context.commands.find(id);
    if (choice == nullptr) {
        choice =
            &m_context.commands.add({.id = id,
                                     .menu = CommandMenu::View,
                                     .text = title,
                                     .hint = tr("Layout %1").arg(title),
                                     .keys = place < Keys ? QKeySequence(FirstKey + place) : QKeySequence(),
                                     .checkable = true});
        m_choices->addAction(choice);
        connect(choice, &QAction::triggered, this,
                [this, own = QString::fromStdString(layout.name)] { use(own); });
    }
    choice->setText(title);
    choice->setVisible(true);
    m_bar->add(*choice, QStringLiteral("switch_") + QString::fromStdString(layout.name));
}

bool LayoutFeature::use(const QString& name) {
    const auto layout = m_book.find(name.toStdString());
    if (!layout) {
        m_context.notify(QString::fromStdString(layout.error().text));
        return false;
    }
    m_used = *layout;
    m_context.panes.arrange(m_used);
    m_map.show(m_sights.enter(m_used, m_map.sight()));
    std::map<QString, QString> keys;
    for (const auto& [command, text] : m_used.keys)
        keys[QString::fromStdString(command)] = QString::fromStdString(text);
    const CommandTable::Refused refused =
        m_context.commands.bind(keys, drivingKeys(m_context.selection.robots()));
    if (!refused.unknown.isEmpty())
        m_context.notify(tr("layout %1 binds keys to what is no command: %2")
                             .arg(name, refused.unknown.join(QStringLiteral(", "))));
    if (!refused.taken.isEmpty())
        m_context.notify(tr("layout %1 binds keys that are none, or that mean something else: %2")
                             .arg(name, refused.taken.join(QStringLiteral(", "))));
    emit padBound(m_used.pad);
    if (QAction* choice = m_context.commands.find(idOf(m_used.name))) choice->setChecked(true);
    m_forget->setEnabled(m_book.isOwn(m_used.name));
    return true;
}

bool LayoutFeature::begin(const QString& name) {
    if (m_book.find(name.toStdString())) {
        m_map.show(ownSight());
        m_sights = LayoutSights(m_map.sight());
    }
    return use(name);
}

MapSight LayoutFeature::ownSight() const {
    return m_sights.own(m_map.sight());
}

std::string LayoutFeature::nameFor(const QString& title) const {
    // Layouts whose titles differ only in punctuation are still different layouts.
    const std::string plain = nameOf(title);
    std::string name = plain;
    for (int more = 2; m_book.isOwn(name); ++more) {
        const auto other = m_book.find(name);
        if (!other || shownTitle(*other) == title || other->title == title.toStdString()) break;
        name = plain + "-" + std::to_string(more);
    }
    return name;
}

bool LayoutFeature::saveAs(const QString& title) {
    WindowLayout layout = m_used;
    layout.title = title.toStdString();
    layout.name = nameFor(title);
    layout.arrangement = m_context.panes.arrangement();
    layout.map = {m_map.sight().look, m_map.sight().follow};
    if (const auto saved = m_book.save(layout); !saved) {
        m_context.notify(QString::fromStdString(saved.error().text));
        return false;
    }
    m_sights.forget(layout.name);
    fill();
    return use(QString::fromStdString(layout.name));
}

void LayoutFeature::askForTitle() {
    auto* question = new QInputDialog(&m_context.window);  // not modal: robots may be driving
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setWindowTitle(tr("Save layout"));
    question->setLabelText(tr("Name of the layout"));
    question->setTextValue(QString::fromStdString(m_used.title));
    connect(question, &QInputDialog::textValueSelected, this,
            [this](const QString& title) { saveAs(title); });
    question->show();
}

void LayoutFeature::forget() {
    if (const auto gone = m_book.remove(m_used.name); !gone) {
        m_context.notify(QString::fromStdString(gone.error().text));
        return;
    }
    m_sights.forget(m_used.name);
    fill();
    std::vector<std::string> errors;
    const auto left = m_book.all(errors);
    if (!left.empty()) use(QString::fromStdString(left.front().name));
}

}  // namespace leitstand
