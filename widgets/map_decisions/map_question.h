#pragma once

#include <vector>

#include <QFrame>
#include <QList>
#include <QString>

class QAction;
class QBoxLayout;
class QLabel;

namespace leitstand {

/// A question to the operator, shown over the map with buttons for the answers. It is centred at the map's
/// lower edge, above questions that were created earlier. On a small map it takes one line. It never takes
/// the focus, so that driving continues.
class MapQuestion final : public QFrame {
    Q_OBJECT
public:
    /// @p name: its objectName(). @p answers: commands of the buttons. @p over: the map, which becomes the
    /// parent.
    MapQuestion(const QString& name, const std::vector<QAction*>& answers, QWidget& over);

    /// Shows @p question; empty hides it. A small map shows only the first line.
    void ask(const QString& question);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void placeAll();  ///< places all questions over the same map
    void place();
    /// Returns all questions over the same map, including this one, in order of creation.
    [[nodiscard]] QList<MapQuestion*> others() const;

    const int m_number;  ///< order of creation among the questions over the same map
    QString m_question;
    QLabel* m_text;
    QBoxLayout* m_parts;
};

}  // namespace leitstand
