#pragma once

#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

class QLabel;
class QMainWindow;
class QWidget;

namespace leitstand {

/// What windows on robots have around their panes, live ones and reviews: a bar above them, and the newest
/// message in the corner of the menus.
class WindowFrame final : public QObject {
    Q_OBJECT
public:
    explicit WindowFrame(QMainWindow& window);

    /// Stacks a bar, which has @p left and @p right at its ends, @p panes and @p below. Menus without entries
    /// are not shown.
    void build(const std::vector<QWidget*>& left, const std::vector<QWidget*>& right, QWidget& panes,
               QWidget* below = nullptr);
    /// Shows @p text as the newest message; its tooltip has those before it too.
    void tell(const QString& text);
    [[nodiscard]] QString newest() const;
    [[nodiscard]] const QStringList& recent() const { return m_recent; }  ///< the newest first

private:
    QMainWindow& m_window;
    QLabel* m_word;
    QStringList m_recent;
};

}  // namespace leitstand
