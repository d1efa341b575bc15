#pragma once

#include <cstdint>
#include <vector>

#include <QAbstractTableModel>
#include <QString>

#include "core/robot/link/link_status.h"
#include "core/robot/streams/stream_request.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// One stream of one robot, and the requests for it.
struct StreamRow {
    RobotFace face;
    StreamStatus stream;
    QString type;             ///< "PointCloud2"
    StreamRequest own;        ///< of the operator
    StreamRequest effective;  ///< after the limits of a thin link
    bool settable = false;    ///< the robot accepts requests for this stream
    bool mayMap = false;      ///< a cloud of a robot that sends several: one of them makes the map
    bool maps = false;        ///< this one does
};

/// Returns the letter of the robot and the name of the stream: "K left pictures".
[[nodiscard]] QString streamNameText(const StreamRow& row);
/// Returns the rate as received and as sent [Hz]: "12 / 15". "on change" for a stream without a steady rate,
/// "off" while it is paused, a dash before the first sample.
[[nodiscard]] QString streamRateText(const StreamStatus& stream);
/// Returns the text of a request: "5 Hz, quality 40, 320 px", "off". Empty: the robot may choose everything.
[[nodiscard]] QString requestText(const StreamRequest& requested);
/// Returns the text of the setting column: the request in effect. It begins with "thin:" when a thin link
/// limits the request, and ends with "not yet" while the robot does not follow it.
[[nodiscard]] QString settingText(const StreamRow& row);
/// Returns Attention when the stream is stale or loses more than 2 % of its samples, Muted when it is paused
/// or nothing arrived yet.
[[nodiscard]] Tone toneOf(const StreamRow& row);
/// Returns the total of all robots: "5.6 Mbit/s"; with the budget of a thin link: "1.8 of 2.0 Mbit/s".
[[nodiscard]] QString linkTotalText(double megabits, bool thin, double budget);

/// Streams of all robots, a row each. The selection is kept as long as the rows are about the same streams.
class StreamTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Type, Rate, Age, Load, Loss, Setting, ColumnCount };
    enum class Of : std::uint8_t {
        Link,  ///< streams as they arrive now
        Log,   ///< streams as recorded, without load, loss and setting: a log does not hold these
    };

    explicit StreamTable(Of of = Of::Link, QObject* parent = nullptr)
        : QAbstractTableModel(parent), m_of(of) {}

    void setRows(std::vector<StreamRow> rows);
    [[nodiscard]] const StreamRow* row(int number) const;  ///< null: there is none

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] static QString text(const StreamRow& row, Column column);

    Of m_of;
    std::vector<StreamRow> m_rows;
};

}  // namespace leitstand
