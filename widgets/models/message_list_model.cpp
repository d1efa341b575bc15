#include "widgets/models/message_list_model.h"

#include <algorithm>

#include "widgets/models/others_text.h"
#include "widgets/models/times.h"
#include "widgets/models/tone.h"

namespace leitstand {
namespace {

constexpr int MostMessages = 500;

}  // namespace

void MessageListModel::add(Severity severity, const QString& reported) {
    const QString text = othersLine(reported);
    const bool known = std::any_of(m_messages.begin(), m_messages.end(),
                                   [&text](const Message& message) { return message.text == text; });
    if (known) return;
    if (rowCount() == MostMessages) dismiss(0);
    beginInsertRows({}, rowCount(), rowCount());
    m_messages.push_back({severity, QTime::currentTime(), text});
    endInsertRows();
}

void MessageListModel::addReported(const QString& reported) {
    const QString text = othersLine(reported);
    const auto known = std::find_if(m_messages.begin(), m_messages.end(),
                                    [&text](const Message& message) { return message.text == text; });
    if (known != m_messages.end()) dismiss(static_cast<int>(known - m_messages.begin()));
    add(Severity::Warning, text);
}

void MessageListModel::dismiss(int row) {
    if (row < 0 || row >= rowCount()) return;
    beginRemoveRows({}, row, row);
    m_messages.erase(m_messages.begin() + row);
    endRemoveRows();
}

void MessageListModel::clear() {
    if (m_messages.empty()) return;
    beginRemoveRows({}, 0, rowCount() - 1);
    m_messages.clear();
    endRemoveRows();
}

int MessageListModel::errorCount() const {
    return static_cast<int>(std::count_if(m_messages.begin(), m_messages.end(), [](const Message& message) {
        return message.severity == Severity::Error;
    }));
}

int MessageListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_messages.size());
}

QVariant MessageListModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Message& message = m_messages[static_cast<std::size_t>(index.row())];
    const bool error = message.severity == Severity::Error;
    switch (role) {
        case Qt::DisplayRole:
            return (error ? tr("▲ Error  %1  %2") : tr("Note  %1  %2"))
                .arg(timeOfDayText(message.at), message.text);
        case Qt::ToolTipRole:
            return message.text;
        case ToneRole:
            return static_cast<int>(error ? Tone::Attention : Tone::Normal);
        default:
            return {};
    }
}

}  // namespace leitstand
