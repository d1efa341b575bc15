#pragma once

#include <QLineEdit>
#include <QStringList>

namespace leitstand {

/// A line of text that says in grey what one may write into it: as many of its words as it is wide, none
/// of them cut.
class HintLine final : public QLineEdit {
    Q_OBJECT
public:
    using QLineEdit::QLineEdit;

    /// @p more: whether other words than @p words are meant too.
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
