#pragma once

#include <QLineEdit>
#include <QStringList>

namespace leitstand {

/// A line edit whose grey placeholder suggests words: as many as fit, without cutting any.
class HintLine final : public QLineEdit {
    Q_OBJECT
public:
    using QLineEdit::QLineEdit;

    /// @p more: whether words other than @p words are possible, too.
    void setHints(const QStringList& words, bool more);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fit();

    QStringList m_words;
    bool m_more = false;
};

}  // namespace leitstand
