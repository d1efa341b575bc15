#pragma once

#include <vector>

#include <QAbstractListModel>
#include <QTime>

namespace leitstand {

/// Messages to the operator, newest last.
class MessageListModel final : public QAbstractListModel {
    Q_OBJECT
public:
    enum class Severity { Warning, Error };

    using QAbstractListModel::QAbstractListModel;

    /// Adds a message with the present time of day. If the text is already in the list, it is not added.
    /// Beyond 500 messages, the oldest are removed. Several lines become one, with dots in between.
    void add(Severity severity, const QString& reported);
    /// Adds a warning. If the text is already in the list, it moves to the end, with the present time.
    void addReported(const QString& reported);
    /// Removes the message in @p row.
    void dismiss(int row);
    void clear();
    /// Returns the number of errors in the list; all others are warnings.
    [[nodiscard]] int errorCount() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    struct Message {
        Severity severity;
        QTime at;
        QString text;
    };
    std::vector<Message> m_messages;
};

}  // namespace leitstand
