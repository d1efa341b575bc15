#pragma once

#include <vector>

#include <QFrame>
#include <QList>
#include <QString>

class QAction;
class QBoxLayout;
class QLabel;

namespace leitstand {

/// Asks the operator something over the map. It lies at the lower edge of what it is over, in the middle,
/// above those that were made before it; of a small map it takes a line. It takes no focus: driving goes on.
class MapQuestion final : public QFrame {
    Q_OBJECT
public:
    /// @p name: objectName(). @p answers: commands of its buttons.
    MapQuestion(const QString& name, const std::vector<QAction*>& answers, QWidget& over);

    /// Empty: nothing is asked. What comes after its first line is left out over a small map.
    void ask(const QString& question);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void placeAll();  ///< that are asked over the same map
    void place();
    /// All over the same map, itself too, as they were made.
    [[nodiscard]] QList<MapQuestion*> others() const;

    const int m_number;  ///< rising, of those over the same map
    QString m_question;
    QLabel* m_text;
    QBoxLayout* m_parts;
};

}  // namespace leitstand
