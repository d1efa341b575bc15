#pragma once

#include <QFrame>
#include <QString>

class QAction;
class QBoxLayout;
class QLabel;

namespace leitstand {

/// Asks the operator something over the map. It lies at the lower edge of what it is over, in the middle; of
/// a small one it takes a line. It takes no focus: driving goes on.
class MapQuestion final : public QFrame {
    Q_OBJECT
public:
    /// @p name: objectName(). @p yes, @p no: commands of its buttons.
    MapQuestion(const QString& name, QAction& yes, QAction& no, QWidget& over);

    /// Empty: nothing is asked. What comes after its first line is left out over a small map.
    void ask(const QString& question);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QString m_question;
    QLabel* m_text;
    QBoxLayout* m_parts;
};

}  // namespace leitstand
