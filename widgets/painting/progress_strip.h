#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;

namespace leitstand {

/// Shows the present work, its progress, and a button that cancels it. Hidden while there is no work.
class ProgressStrip final : public QWidget {
    Q_OBJECT
public:
    /// @p cancel: triggered by the button.
    explicit ProgressStrip(QAction& cancel, QWidget* parent = nullptr);

    /// Shows the strip. @p text: the present work. @p fraction: the finished share of it, 0 to 1.
    void show(const QString& text, double fraction);
    using QWidget::show;

private:
    QLabel* m_text;
    QProgressBar* m_bar;
};

}  // namespace leitstand
