#pragma once

#include <vector>

#include <QFrame>
#include <QList>
#include <QString>

class QAction;
class QBoxLayout;
class QLabel;

namespace leitstand {

/// Asks the operator a question over the map. It lies centred at the map's lower edge, above the questions
/// made before it; on a small map it takes one line. It takes no focus: driving goes on.
class MapQuestion final : public QFrame {
    Q_OBJECT
public:
    /// @p name: objectName(). @p answers: commands of its buttons. @p over: the map.
    MapQuestion(const QString& name, const std::vector<QAction*>& answers, QWidget& over);

    /// Shows @p question; empty hides it. A small map shows only the first line.
    void ask(const QString& question);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void placeAll();  ///< all questions over the same map
    void place();
    /// Returns all questions over the same map, including this one, in order of creation.
    [[nodiscard]] QList<MapQuestion*> others() const;

    const int m_number;  ///< rising among those over the same map
    QString m_question;
    QLabel* m_text;
    QBoxLayout* m_parts;
};

}  // namespace leitstand
