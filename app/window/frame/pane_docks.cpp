#include "app/window/frame/pane_docks.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QAction>
#include <QDockWidget>

namespace leitstand {
namespace {

/// Returns the first pane that is a direct part of @p split, else one of its first part. Across the split,
/// the size of a direct part is that of the whole split.
QString firstOf(const PaneSplit& split) {
    if (!split.pane.empty()) return QString::fromStdString(split.pane);
    for (const PaneSplit& part : split.parts) {
        if (!part.pane.empty()) return QString::fromStdString(part.pane);
    }
    return firstOf(split.parts.front());
}

/// Returns the pane at the upper left corner of @p split, from which its docks are split.
QString cornerOf(const PaneSplit& split) {
    return split.pane.empty() ? cornerOf(split.parts.front()) : QString::fromStdString(split.pane);
}

/// Replaces a dock's title bar and has no height.
class NoTitle final : public QWidget {
public:
    using QWidget::QWidget;
    [[nodiscard]] QSize sizeHint() const override { return {0, 0}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }
};

}  // namespace

PaneDocks::PaneDocks(QWidget* parent) : QMainWindow(parent, Qt::Widget) {
    setObjectName(QStringLiteral("panes"));
    setDockOptions(AllowNestedDocks | AllowTabbedDocks);
    setFocusPolicy(Qt::ClickFocus);
    setContextMenuPolicy(Qt::NoContextMenu);  // panes are shown and hidden in the View menu
}

void PaneDocks::add(const QString& id, const QString& title, QWidget& pane, const QString& formerId) {
    auto* dock = new QDockWidget(title, this);
    // Saved arrangements identify docks by their object name.
    dock->setObjectName(formerId.isEmpty() ? id : formerId);
    if (!formerId.isEmpty()) m_former[formerId] = id;
    dock->setAccessibleName(title);
    dock->setWidget(&pane);
    dress(*dock, m_arranging);
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    dock->hide();
    m_ids.push_back(id);
    m_docks[id] = dock;
    m_strays.insert(dock);
    m_toggles[dock] = toggleOf(*dock);
}

/// Like the dock's own action, but gives a dock without a place one before showing it. Else it would squeeze
/// its neighbours.
QAction* PaneDocks::toggleOf(QDockWidget& dock) {
    const QAction* const own = dock.toggleViewAction();
    auto* toggle = new QAction(own->text(), &dock);
    toggle->setCheckable(true);
    connect(own, &QAction::changed, toggle, [own, toggle] {
        toggle->setText(own->text());
        toggle->setChecked(own->isChecked());
    });
    connect(toggle, &QAction::triggered, this, [this, &dock](bool shown) {
        if (shown) return open(dock);
        dock.close();
    });
    return toggle;
}

void PaneDocks::open(const QString& id) {
    if (QDockWidget* const found = dock(id)) open(*found);
}

void PaneDocks::addSheet(const QString& id, const QStringList& hosts) {
    m_sheets[id] = hosts;
    // Neighbours get their room back when it closes.
    connect(dock(id)->toggleViewAction(), &QAction::toggled, this, &PaneDocks::fit);
}

void PaneDocks::putAway(const QString& id) {
    QDockWidget* const found = dock(id);
    if (found != nullptr && m_strays.contains(found) && !found->isFloating()) found->close();
}

void PaneDocks::open(QDockWidget& dock) {
    if (m_sheets.contains(idOf(dock.objectName())) && m_strays.contains(&dock)) {
        if (!dock.isFloating() && dock.isHidden()) settle(dock);
        dock.show();
        dock.raise();
        return fit();
    }
    if (m_strays.erase(&dock) > 0 && !dock.isFloating()) {
        if (QDockWidget* const host = hostOf(dock)) tabifyDockWidget(host, &dock);
    }
    dock.show();
    dock.raise();
}

void PaneDocks::settle(QDockWidget& sheet) {
    constexpr int LeastBeside = 300;  ///< least width that a host keeps [px]
    const QString id = idOf(sheet.objectName());
    QDockWidget* const host = sheetHost(sheet, m_sheets.at(id));
    if (host == nullptr) return;
    const QSize needed = sheet.widget()->sizeHint();
    const QString hostId = idOf(host->objectName());
    const bool allowed = m_sheets.at(id).contains(hostId);
    const bool beside = !allowed || host->width() >= needed.width() + LeastBeside;
    if (beside) {
        splitDockWidget(host, &sheet, Qt::Horizontal);
    } else {
        tabifyDockWidget(host, &sheet);
    }
    m_stays[id] = {hostId, beside};
    if (!m_placed.pane.empty() || !m_placed.parts.empty()) return;
    sheet.show();  // in an arrangement of the operator's own
    resizeDocks({&sheet}, {needed.width()}, Qt::Horizontal);
    if (host->height() < needed.height()) resizeDocks({host}, {needed.height()}, Qt::Vertical);
}

QDockWidget* PaneDocks::sheetHost(const QDockWidget& sheet, const QStringList& hosts) const {
    const auto inSight = [](const QDockWidget& one) { return !one.isHidden() && !one.isFloating(); };
    for (const QString& id : hosts) {
        QDockWidget* const host = dock(id);
        if (host != nullptr && inSight(*host)) return host;
    }
    // Else the widest, which keeps a part of its room.
    QDockWidget* widest = nullptr;
    for (const auto& [id, other] : m_docks) {
        if (other == &sheet || !inSight(*other)) continue;
        if (widest == nullptr || other->width() > widest->width()) widest = other;
    }
    return widest;
}

QDockWidget* PaneDocks::guestOf(const std::string& id, bool beside) const {
    for (const auto& [sheet, stay] : m_stays) {
        QDockWidget* const guest = dock(sheet);
        if (stay.host.toStdString() == id && stay.beside == beside && !guest->isHidden() &&
            !guest->isFloating())
            return guest;
    }
    return nullptr;
}

/// Returns the smallest pane with the room that @p dock needs, or most of it. Null when there is none.
QDockWidget* PaneDocks::hostOf(const QDockWidget& dock) const {
    constexpr double Enough = 0.8;  // part of the needed room that suffices; lists scroll
    const QSize needed = dock.widget()->sizeHint().expandedTo(dock.widget()->minimumSizeHint());
    const auto share = [](int has, int wants) { return wants > 0 ? std::min(1.0, 1.0 * has / wants) : 1.0; };
    QDockWidget* best = nullptr;
    std::tuple<bool, double, int> mark;  // may be covered; how much of what is needed; how small
    for (const auto& [id, other] : m_docks) {
        if (other == &dock || other->isHidden() || other->isFloating()) continue;
        const QSize room = other->size();
        const double fits = share(room.width(), needed.width()) * share(room.height(), needed.height());
        const std::tuple here(!m_inSight.contains(id), std::min(Enough, fits), -room.width() * room.height());
        if (best != nullptr && here <= mark) continue;
        best = other;
        mark = here;
    }
    return best;
}

QStringList PaneDocks::ids() const {
    return {m_ids.begin(), m_ids.end()};
}

QString PaneDocks::idOf(const QString& name) const {
    const auto found = m_former.find(name);
    return found == m_former.end() ? name : found->second;
}

QDockWidget* PaneDocks::dock(const QString& id) const {
    const auto found = m_docks.find(idOf(id));
    return found == m_docks.end() ? nullptr : found->second;
}

bool PaneDocks::isPaneVisible(const QString& id) const {
    const QDockWidget* const found = dock(id);
    return found != nullptr && !found->isHidden();
}

QAction* PaneDocks::visibility(const QString& id) const {
    const QDockWidget* const found = dock(id);
    return found == nullptr ? nullptr : m_toggles.at(found);
}

PaneSplit PaneDocks::known(const PaneSplit& split) const {
    PaneSplit kept = split;
    if (!split.pane.empty()) {
        kept.pane = idOf(QString::fromStdString(split.pane)).toStdString();
        return has(QString::fromStdString(kept.pane)) ? kept : PaneSplit{};
    }
    kept.parts.clear();
    for (const PaneSplit& part : split.parts) {
        PaneSplit inner = known(part);
        if (!inner.pane.empty() || !inner.parts.empty()) kept.parts.push_back(std::move(inner));
    }
    if (kept.parts.size() != 1) return kept;
    PaneSplit only = std::move(kept.parts.front());
    only.share = split.share;
    return only;
}

void PaneDocks::arrange(const WindowLayout& layout) {
    const PaneSplit tree = known(layout.panes);
    for (const auto& [id, dock] : m_docks) {
        dock->setFloating(false);
        removeDockWidget(dock);
    }
    m_placed = {};
    m_strays.clear();
    m_stays.clear();
    m_unseen.clear();
    const auto named = panesIn(tree);
    if (!layout.arrangement.empty()) {
        for (const auto& [id, dock] : m_docks) addDockWidget(Qt::LeftDockWidgetArea, dock);
        const auto state = QByteArray::fromBase64(QByteArray::fromStdString(layout.arrangement));
        if (restoreState(state)) {
            if (!isVisible()) m_unseen = state;
            for (const auto& [id, dock] : m_docks) {
                // A pane that the operator hid comes back where the layout has it.
                const bool known = std::find(named.begin(), named.end(), id.toStdString()) != named.end();
                if (!known && dock->isHidden() && tabifiedDockWidgets(dock).isEmpty()) m_strays.insert(dock);
            }
            return;
        }
        for (const auto& [id, dock] : m_docks) removeDockWidget(dock);
    }
    if (named.empty()) return;
    addDockWidget(Qt::LeftDockWidgetArea, dock(cornerOf(tree)));
    place(tree);
    for (const auto& [id, dock] : m_docks) {
        const bool shown = std::find(named.begin(), named.end(), id.toStdString()) != named.end();
        // arrangement() includes hidden docks.
        if (!shown) addDockWidget(Qt::LeftDockWidgetArea, dock), m_strays.insert(dock);
        dock->setVisible(shown);
    }
    m_placed = tree;
    fit();
}

void PaneDocks::place(const PaneSplit& split) {
    const Qt::Orientation along = split.vertical ? Qt::Vertical : Qt::Horizontal;
    for (std::size_t i = 1; i < split.parts.size(); ++i)
        splitDockWidget(dock(cornerOf(split.parts[i - 1])), dock(cornerOf(split.parts[i])), along);
    for (const PaneSplit& part : split.parts) place(part);
}

QSize PaneDocks::needOf(const PaneSplit& split) const {
    if (!split.pane.empty()) {
        const QDockWidget* const guest = guestOf(split.pane, false);
        return guest == nullptr ? QSize(0, 0) : guest->widget()->sizeHint();
    }
    QSize need(0, 0);
    for (const PaneSplit& part : split.parts) {
        const QSize inner = needOf(part);
        need = split.vertical ? QSize(std::max(need.width(), inner.width()), need.height() + inner.height())
                              : QSize(need.width() + inner.width(), std::max(need.height(), inner.height()));
    }
    return need;
}

/// Divides @p room by shares. What a sheet needs is taken from the others.
QList<int> PaneDocks::sizesIn(const PaneSplit& split, QSize room) const {
    const double length = split.vertical ? room.height() : room.width();
    double shares = 0.0, left = length, open = 0.0;
    for (const PaneSplit& part : split.parts) shares += part.share;
    QList<int> sizes;
    for (const PaneSplit& part : split.parts) {
        const QSize need = needOf(part);
        const int least = split.vertical ? need.height() : need.width();
        const bool needs = least > length * part.share / shares;
        sizes += needs ? least : 0;
        left -= needs ? least : 0.0;
        open += needs ? 0.0 : part.share;
    }
    for (qsizetype i = 0; i < sizes.size(); ++i) {
        const double share = split.parts[static_cast<std::size_t>(i)].share;
        if (sizes[i] == 0) sizes[i] = std::max(1, static_cast<int>(left * share / open));
    }
    return sizes;
}

void PaneDocks::giveRoom(const PaneSplit& split, QSize room) {
    if (split.parts.empty()) return;
    QList<QDockWidget*> docks;
    QList<int> sizes;
    const QList<int> shares = sizesIn(split, room);
    for (std::size_t i = 0; i < split.parts.size(); ++i) {
        const PaneSplit& part = split.parts[i];
        int size = shares[static_cast<qsizetype>(i)];
        QSize inner = room;
        (split.vertical ? inner.rheight() : inner.rwidth()) = size;
        giveRoom(part, inner);  // first: resizing the docks around it still changes those within
        QDockWidget* const guest = part.pane.empty() ? nullptr : guestOf(part.pane, true);
        const int wide = guest == nullptr ? 0 : guest->widget()->sizeHint().width();
        docks += dock(firstOf(part));
        if (guest != nullptr && split.vertical) {
            resizeDocks({docks.back(), guest}, {std::max(1, room.width() - wide), wide}, Qt::Horizontal);
        } else if (guest != nullptr) {
            docks += guest;
            sizes += std::max(1, size - wide);
            size = wide;
        }
        sizes += size;
    }
    resizeDocks(docks, sizes, split.vertical ? Qt::Vertical : Qt::Horizontal);
}

void PaneDocks::fit() {
    if (isVisible()) giveRoom(m_placed, size());
}

std::string PaneDocks::arrangement() const {
    return saveState().toBase64().toStdString();
}

void PaneDocks::swap(const QString& one, const QString& other) {
    QDockWidget *const here = dock(one), *const there = dock(other);
    if (here == nullptr || there == nullptr || here == there) return;
    std::vector<QDockWidget*> guests;  // sheets go where their pane goes
    for (const QString& id : {one, other}) {
        for (const bool beside : {false, true}) {
            if (QDockWidget* const guest = guestOf(id.toStdString(), beside)) guests.push_back(guest);
        }
    }
    for (QDockWidget* guest : guests) guest->close();
    QWidget *const first = here->widget(), *const second = there->widget();
    const bool firstShown = !here->isHidden(), secondShown = !there->isHidden();
    const QString title = here->windowTitle();
    here->setWidget(second);
    there->setWidget(first);
    // Titles and names of docks move with their panes.
    here->setWindowTitle(there->windowTitle());
    there->setWindowTitle(title);
    const QString name = here->objectName();
    here->setObjectName(there->objectName());
    there->setObjectName(name);
    std::swap(m_docks[idOf(one)], m_docks[idOf(other)]);
    here->setVisible(firstShown);
    there->setVisible(secondShown);
    for (QWidget* pane : {first, second}) pane->show();
    const auto exchange = [&](auto&& self, PaneSplit& split) -> void {
        if (split.pane == one.toStdString()) {
            split.pane = other.toStdString();
        } else if (split.pane == other.toStdString()) {
            split.pane = one.toStdString();
        }
        for (PaneSplit& part : split.parts) self(self, part);
    };
    exchange(exchange, m_placed);
    fit();
    for (QDockWidget* guest : guests) open(*guest);
}

void PaneDocks::dress(QDockWidget& dock, bool withTitle) {
    QWidget* const before = dock.titleBarWidget();
    if (withTitle) {
        dock.setTitleBarWidget(nullptr);
    } else {
        dock.setTitleBarWidget(new NoTitle(&dock));
    }
    delete before;
    // The menu cannot show and hide a dock that is not closable.
    const QDockWidget::DockWidgetFeatures moves =
        QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable;
    dock.setFeatures(withTitle ? QDockWidget::DockWidgetClosable | moves
                               : QDockWidget::DockWidgetFeatures(QDockWidget::DockWidgetClosable));
}

void PaneDocks::setArranging(bool on) {
    if (on == m_arranging) return;
    m_arranging = on;
    if (on) m_placed = {};  // from now on the operator decides
    for (const auto& [id, dock] : m_docks) dress(*dock, on);
}

void PaneDocks::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    fit();
}

void PaneDocks::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    // Qt forgets the sizes of an arrangement when the window is resized before it is shown.
    if (!m_unseen.isEmpty()) restoreState(std::exchange(m_unseen, {}));
    fit();
}

}  // namespace leitstand
