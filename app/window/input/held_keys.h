#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include <QObject>

class QKeyEvent;
class QWidget;

namespace leitstand {

/// Watches which of some keys are held in a window, for what moves while a key is held. In text fields these
/// keys only type. A key that went down counts as released even when a modifier or a menu came meanwhile, and
/// all are released when the window loses the keyboard.
class HeldKeys final : public QObject {
    Q_OBJECT
public:
    /// Returns what a key means; empty: it is none of these keys.
    using Meaning = std::function<std::optional<int>(const QKeyEvent&)>;

    /// Watches the keys of @p window and of the widgets in it. @p driving returns whether the operator drives
    /// a robot. If so, Ctrl may be held with these keys, since it drives fast; otherwise they do nothing with
    /// it.
    HeldKeys(QWidget& window, Meaning meaning, std::function<bool()> driving);

    [[nodiscard]] bool isHeld(int meaning) const { return m_held.contains(meaning); }
    /// Returns 1 while @p plus is held, -1 while @p minus is, otherwise 0.
    [[nodiscard]] double share(int plus, int minus) const {
        return static_cast<double>(m_held.count(plus)) - static_cast<double>(m_held.count(minus));
    }
    void letGo();                                             ///< counts all keys as released
    [[nodiscard]] bool withShift() const { return m_shift; }  ///< at the last change
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void pressed(int meaning);
    void changed();  ///< a key went down or up

private:
    [[nodiscard]] bool isOurs(const QKeyEvent& event) const;
    void press(const QKeyEvent& event);
    [[nodiscard]] bool release(const QKeyEvent& event);
    [[nodiscard]] static std::uint64_t keyOf(const QKeyEvent& event);

    QWidget& m_window;
    Meaning m_meaning;
    std::function<bool()> m_driving;
    std::map<std::uint64_t, int> m_down;  ///< keys that are held, and what they meant when they went down
    std::set<int> m_held;                 ///< meanings of those
    bool m_shift = false;
};

}  // namespace leitstand
