#pragma once

#include <QFrame>

class QAction;
class QLabel;

namespace leitstand {

/// Asks the operator something over the map. It lies at the lower edge of what it is over, in the middle,
/// and takes no focus: driving goes on.
class MapQuestion final : public QFrame {
    Q_OBJECT
public:
    /// @p name: objectName(). @p yes, @p no: commands of its buttons.
    MapQuestion(const QString& name, QAction& yes, QAction& no, QWidget& over);

    /// Empty: nothing is asked.
    void ask(const QString& question);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QLabel* m_text;
};

}  // namespace leitstand
