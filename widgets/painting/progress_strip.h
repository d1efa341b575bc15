#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;

namespace leitstand {

/// What is being worked on, how far it is, and a button that ends it; hidden while there is no work.
class ProgressStrip final : public QWidget {
    Q_OBJECT
public:
    /// @p cancel is what the button triggers.
    explicit ProgressStrip(QAction& cancel, QWidget* parent = nullptr);

    /// Shows that @p text is done to @p fraction, 0 to 1.
    void show(const QString& text, double fraction);
    using QWidget::show;

private:
    QLabel* m_text;
    QProgressBar* m_bar;
};

}  // namespace leitstand
